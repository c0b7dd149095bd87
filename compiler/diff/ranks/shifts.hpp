#pragma once
// SPDX-License-Identifier: MIT
// How it changed whether one task takes a group from another one, and the sentence for it.

#include "compiler/diff/ranks/takes_by_name.hpp"

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

namespace director::compiler::diff {

/// Gains come first. In passing: while control passes from one pack, provider or requester to another.
enum class Shift { gained, always, more, more_in_passing, lost, not_always, fewer, fewer_in_passing };

ChangeKind kind_of(Shift shift);
/// "WINNER can now take WHAT". `what`: groups, and from which tasks.
std::string sentence(Shift shift, const std::string& winner, const std::string& what);

/// Of one group. Encounters that only one side has count only for whether it is taken never, sometimes or always: at
/// all, and at each place where both sides may request the two.
std::vector<Shift> shifts(const Encounters& before, const Encounters& now);

/// A member of a unit that makes a difference, where nothing else does.
struct Mate {
  std::uint32_t name = 0; ///< its number; 0: none
  bool is_losers = false;
  auto operator<=>(const Mate&) const = default;
};
Mate differing_mate(const Encounters& before, const Encounters& now);

} // namespace director::compiler::diff
