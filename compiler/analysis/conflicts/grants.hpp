#pragma once
// SPDX-License-Identifier: MIT
// Which tasks are ever granted, as far as what is held before them tells. From some entries down: for whom a task runs
// sometimes, and what is certain to be held by then; each follows from the other, so both are found together. It errs
// on one side only: what is not granted here never is.

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

/// By what is held.
using Held = std::map<GroupId, Taker>;

/// Why a provider is not granted for an entry.
struct Refusal {
  ProviderId provider{};
  Taker taker;
};

/// An entry that is never granted, with a reason for each provider that could run for it.
struct Refused {
  std::optional<GroupId> requester; ///< nothing: root
  const Task* task = nullptr;
  std::vector<Refusal> refusals; ///< never empty
};

class Grants {
public:
  /// Below all roots. Only what is taken steadily counts.
  Grants(const Input& input, Takers& takers, Packmates& packmates);
  /// Only below this pack, while that provider is active, whoever its group runs for.
  Grants(const Input& input, Takers& takers, Packmates& packmates, ProviderId above, const Pack& pack);

  /// Tasks that are never granted, by edge: the entries for them. Not where others of their unit are to blame.
  const std::map<EdgeId, std::vector<Refused>>& refused() const { return refused_; }
  /// Providers that never run although others of their group do, and what they lack at the first entry.
  const std::map<ProviderId, Refused>& idle() const { return idle_; }
  /// Some request for it comes to be tried with something to be had: else it is blocked, and waits for no condition.
  bool is_tried(GroupId group) const { return standing_.count(group) != 0; }
  /// How many packs were looked at, some of them more than once.
  std::size_t visits() const { return visits_; }
  /// The shortest chain of requests that leads to this group from the pack.
  std::vector<ChainStep> chain_to(GroupId group) const;

private:
  struct Standing {
    Held held;     ///< whenever the group runs
    Held optional; ///< and by the time when something optional below it is tried
  };
  struct Entry {
    const Task* task = nullptr;
    bool in_unit = false, grantable = false;
    Held held;      ///< when it is tried
    Standing below; ///< when what is below it is
  };

  void run();
  void visit(GroupId group, bool last);
  void visit(const Provider& provider, const Pack& pack, const Standing& above, bool last);
  Standing standing_of(GroupId group);
  std::vector<Entry> entries_of(const Provider& provider, const Pack& pack, const Standing& above);
  std::optional<Taker> find_taker(std::optional<GroupId> requester, const Task& task, ProviderId provider,
                                  const Held& held);
  bool is_grantable(std::optional<GroupId> requester, const Task& task, const Held& held);
  void enter(std::optional<GroupId> requester, const Entry& entry);
  void refuse(std::optional<GroupId> requester, const Entry& entry);

  const Input& input_;
  Takers& takers_;
  Packmates& packmates_;
  std::optional<ProviderId> origin_;
  const Pack* pack_ = nullptr; ///< of the origin
  std::size_t visits_ = 0;
  std::map<GroupId, Standing> standing_;
  std::set<std::pair<std::size_t, GroupId>> open_; ///< in the graph's order
  SparseSet<ProviderId> granted_;
  SparseSet<EdgeId> fed_;
  std::map<EdgeId, std::vector<Refused>> refused_;
  std::map<ProviderId, Refused> idle_;
};

} // namespace director::analysis
