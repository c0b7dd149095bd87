#pragma once
// SPDX-License-Identifier: MIT
// Finds the tasks that are ever granted, given what is held before them. From some entries down: the requesters for
// which a task may run, and what is certainly held by then; both are found together, as each depends on the other. An
// over-approximation: what is not granted here is never granted.

#include "compiler/analysis/chains/sparse_set.hpp"
#include "compiler/analysis/chains/step.hpp"
#include "compiler/analysis/conflicts/packmates.hpp"
#include "compiler/analysis/conflicts/takers.hpp"
#include "compiler/analysis/input.hpp"

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace director::analysis {

/// The groups that are held, each with its taker.
using Held = std::map<GroupId, Taker>;

/// Why a provider is not granted for an entry.
struct Refusal {
  ProviderId provider{};
  Taker taker;
  std::vector<Taker> others; ///< that would refuse it too, each without those before it
};

/// An entry that is never granted, with a reason for each provider that could run for it.
struct Refused {
  std::optional<GroupId> requester; ///< empty: root
  const Task* task = nullptr;
  std::vector<Refusal> refusals; ///< never empty
  /// As few takers as refuse all providers together, if it takes more than one.
  std::vector<Taker> together;
};

class Grants {
public:
  /// Below all roots. Only what is held steadily counts.
  Grants(const Input& input, Takers& takers, Packmates& packmates);
  /// With which active providers the requests of a pack remain: only with the one that made them (`above`), or with any
  /// of its group, which may keep them.
  enum class Running { above, any };
  /// Only below this pack of `above`, for any requester of its group.
  Grants(const Input& input, Takers& takers, Packmates& packmates, ProviderId above, const Pack& pack, Running running);

  /// Tasks that are never granted, by edge: their entries. Without those that fail because of other members of their
  /// unit.
  const std::map<EdgeId, std::vector<Refused>>& refused() const { return refused_; }
  /// Providers that never run although others of their group do, and what they lack at the first entry.
  const std::map<ProviderId, Refused>& idle() const { return idle_; }
  /// Whether some request for it is tried with something available: otherwise it is blocked, and waits for no
  /// condition.
  bool is_tried(GroupId group) const { return standing_.count(group) != 0; }
  /// How many packs were visited, some more than once.
  std::size_t visits() const { return visits_; }
  /// The shortest chain of requests that leads to this group from the pack.
  std::vector<ChainStep> chain_to(GroupId group) const;

private:
  struct Standing {
    Held held;     ///< whenever the group runs
    Held optional; ///< and when something optional below it is tried
  };
  struct Entry {
    const Task* task = nullptr;
    bool in_unit = false, grantable = false;
    Held held;      ///< when it is tried
    Standing below; ///< when something below it is tried
  };

  void run();
  void visit(GroupId group, bool last);
  void visit(const Provider& provider, const Pack& pack, const Standing& above, bool last);
  Standing standing_of(GroupId group);
  std::vector<Entry> entries_of(const Provider& provider, const Pack& pack, const Standing& above);
  /// `granted`: the task may be granted already, with another provider.
  std::optional<Taker> find_taker(std::optional<GroupId> requester, const Task& task, ProviderId provider,
                                  const Held& held, bool granted = false);
  bool is_grantable(std::optional<GroupId> requester, const Task& task, const Held& held);
  std::vector<Taker> find_others(const Refused& refused, const Refusal& refusal, Held held);
  std::vector<Taker> find_together(const Refused& refused, const Held& held);
  void enter(std::optional<GroupId> requester, const Entry& entry);
  void refuse(std::optional<GroupId> requester, const Entry& entry);

  const Input& input_;
  Takers& takers_;
  Packmates& packmates_;
  std::optional<ProviderId> origin_;
  const Pack* pack_ = nullptr; ///< of the origin
  Running running_ = Running::above;
  std::size_t visits_ = 0;
  std::map<GroupId, Standing> standing_;
  std::set<std::pair<std::size_t, GroupId>> open_; ///< in the graph's order
  SparseSet<ProviderId> granted_;
  SparseSet<EdgeId> fed_;
  std::map<EdgeId, std::vector<Refused>> refused_;
  std::map<ProviderId, Refused> idle_;
};

} // namespace director::analysis
