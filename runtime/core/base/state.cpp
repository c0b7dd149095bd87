// docs/bounds.md: the memory of one behaviour, as arrays in one block.
// SPDX-License-Identifier: MIT

#include "runtime/core/base/state.hpp"

#include <bit>

namespace director {

/// A State is nothing but pointers, in the order of the layout.
State State::in(std::byte* memory, const Layout& layout) {
  std::array<std::byte*, arrays + 1> begin;
  static_assert(sizeof(State) == sizeof(begin));
  for (std::size_t i = 0; i < begin.size(); ++i) begin[i] = memory + layout.begin[i];
  return std::bit_cast<State>(begin);
}

} // namespace director
