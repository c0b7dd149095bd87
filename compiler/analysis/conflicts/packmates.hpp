#pragma once
// SPDX-License-Identifier: MIT
// Finds what the other entries of a pack take from one of them, and from everything below it.

#include "compiler/analysis/conflicts/spoilers.hpp"
#include "compiler/analysis/conflicts/takers.hpp"

#include <deque>
#include <map>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace director::analysis {

/// Another entry of the pack that takes something.
struct Packmate {
  Taker taker;
  const Unit* unit = nullptr; ///< in which it is granted
  bool from_entry = false;    ///< the entry itself finds it taken
  bool from_below = false;    ///< so does everything below it; if false, only what is optional there
};

/// One entry of a pack.
struct PackEntry {
  const Task* task = nullptr;
  const Unit* unit = nullptr; ///< that it is a member of, if of any
  std::vector<Packmate> mates;
  const Unit* company = nullptr; ///< all that may be in one unit with it at some level; null if none may
};

/// Computed on first use, and kept.
class Packmates {
public:
  Packmates(const Input& input, Takers& takers) : input_(input), takers_(takers) {}

  /// The entries of the provider's pack. In a flat list, of which any part may be requested, each entry is alone.
  const std::vector<PackEntry>& of(const Provider& provider, const Pack& pack);
  /// Whether this unit may have to wait although it could have everything, because a group that goes before it and is
  /// about to run may request some of that (semantics.md 4.4, "Defer"). Meanwhile tasks of the requester that were
  /// granted before may take it.
  bool may_be_deferred(GroupId requester, const Unit& unit);

private:
  struct Rival {
    const Task* task = nullptr;
    const Unit* unit = nullptr;
    bool always = false, at_first = false; ///< UnitTakes
  };
  using ByTaken = std::map<GroupId, std::vector<Rival>>;

  void add_rivals(GroupId requester, const Unit& unit, bool is_all, ByTaken& to);
  void add_mates(GroupId requester, const ByTaken& by_taken, PackEntry& entry);
  std::optional<Packmate> find_mate(GroupId requester, const Rival& rival, GroupId group, const PackEntry& entry);
  const Task* find_leader(GroupId requester, const Rival& rival, const PackEntry& entry) const;
  bool is_first(GroupId requester, const Task& by, const Task& over) const;
  Beside beside(GroupId requester, const Unit& unit, const Task& by, const Task& over) const;
  Groups spoilers_of(GroupId requester, const Rival& rival, const Task& over);
  const Spoilers& spoilers(const Beside& beside);
  bool may_keep(GroupId requester, const Unit& unit, const Task& over);
  bool may_be_requested_above(GroupId requester, const Task& member, GroupId group);

  const Input& input_;
  Takers& takers_;
  std::unordered_map<const Pack*, std::vector<PackEntry>> entries_;
  std::deque<Unit> units_;                                                            ///< a deque, for stable addresses
  std::map<std::pair<const Task*, const Task*>, std::unique_ptr<Spoilers>> spoilers_; ///< null: everything goes after
  std::unordered_map<const Unit*, bool> may_be_deferred_;
};

} // namespace director::analysis
