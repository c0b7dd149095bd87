#pragma once
// SPDX-License-Identifier: MIT
// Which slot of OverflowSlots belongs to whom: one to each root task, in their order; then one to each state that is
// external, in theirs; then one to cancel_all. `Facts`: see program.hpp.

#include "runtime/core/base/tables.hpp"

#include <cstddef>

namespace director {

template <class Facts>
struct OverflowSlotOf {
  /// `state`: one that is external.
  static constexpr Index of_state(Index state) {
    auto slot = static_cast<Index>(Facts::Roots::size);
    for (Index before = 0; before < state; ++before) {
      if (Facts::States::domains[before].external) ++slot;
    }
    return slot;
  }
  static constexpr Index of_all = of_state(static_cast<Index>(Facts::States::domains.size()));
  static constexpr std::size_t count = of_all + std::size_t{1};
};

} // namespace director
