#pragma once
// SPDX-License-Identifier: MIT
// A unit is tried at the place of its first member (semantics.md 4.4), so a member may go before an entry of its list
// that is apart and that its own rank is behind: with which other members.

#include "compiler/model/model.hpp"

#include <compare>
#include <cstdint>
#include <functional>
#include <vector>

namespace director::analysis {

using namespace director::compiler;

/// Whether the place of the unit decides between its member, with what it takes at once, and the rival. An optional
/// rival goes after the unit wherever that is.
inline bool is_placed(const compiler::Level& member, const compiler::Level& rival) {
  return member.shares_unit() && rival.apart && !rival.optional;
}

/// Another entry that may be in the unit of a member, at one of its levels.
struct Mate {
  const Task* task = nullptr;
  const Task::NamedLevel* level = nullptr;
  std::int32_t priority = 0;
};

/// All of one list, without the rival.
std::vector<Mate> mates_of(const Model& model, const std::vector<Task>& entries, EdgeId member, EdgeId rival);

/// Whether one of the entries is a mate at each of its levels, and passes the test.
bool any_always(const std::vector<Mate>& mates, const std::function<bool(const Mate&)>& test);

/// A mate that does not go after the rival.
struct Leader {
  EdgeId edge{};
  std::int32_t priority = 0;
  bool if_older = false; ///< its priority is that of the rival: the older request of the two goes first
  auto operator<=>(const Leader&) const = default;
};

struct Leaders {
  std::vector<Leader> all; ///< by edge and level
  bool always = false;     ///< in every request one of them is requested too, and goes before the rival
};

/// `whole`: all entries are requested, or none. Equals lead only a member of lower priority: else it is an equal too.
Leaders find_leaders(const Model& model, const std::vector<Task>& entries, bool whole, EdgeId member,
                     std::int32_t priority, EdgeId rival, std::int32_t rivals_priority);

} // namespace director::analysis
