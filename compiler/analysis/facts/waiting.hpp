#pragma once
// SPDX-License-Identifier: MIT
// Finds the tasks that ever wait for a condition, and the providers whose conditions they wait for (semantics.md 4.4,
// "Refuse"): of a unit that is refused, the first combination counts whose groups are available, whatever its
// conditions.

#include "compiler/analysis/facts/facts.hpp"

#include <map>
#include <set>
#include <unordered_map>
#include <vector>

namespace director::analysis {

/// Whether the first one's needs are available whenever the second one's are.
bool needs_no_more(const Provider& first, const Provider& second);

/// Whether it can run whenever the other one can, by their own conditions and needs.
bool can_always_replace(const Model& model, ProviderId id, ProviderId other);

/// Valid for one time: what the facts allow when it is called.
class Waiting {
public:
  Waiting(const Model& model, const Facts& facts);

  /// Whether its conditions may be what a task for its group waits for. Not if an earlier provider needs nothing more
  /// than it does, unless a push moves it to the front.
  bool may_be_first(ProviderId id) const;

  /// Whether a task for this requested group may be refused for a condition, its own or that of another member of its
  /// unit.
  bool may_wait(GroupId group);

private:
  /// A place where a task is requested.
  struct Entry {
    ProviderId provider{};
    const Pack* pack = nullptr;
    bool in_unit = false;
  };

  /// Whether a member of its unit may be refused for a condition.
  bool unit_waits(const Pack& pack);
  /// Whether its conditions allow a grant wherever its groups are available.
  bool always_finds_choice(GroupId group, const Region& context);
  /// `known`: the answers for this context so far.
  bool can_do_without(GroupId group, const Region& context, std::map<GroupId, bool>& known) const;
  bool holds_always(GroupId group, const Region& context, std::set<GroupId>& seen) const;

  const Model& model_;
  const Facts& facts_;
  std::unordered_map<EdgeId, std::vector<Entry>> entries_;
  std::unordered_map<const Pack*, bool> unit_waits_;
  std::map<GroupId, bool> carefree_; ///< in its own context
};

} // namespace director::analysis
