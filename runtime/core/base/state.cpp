// docs/bounds.md: the memory of one behaviour, as arrays in one block.
// SPDX-License-Identifier: MIT

#include "runtime/core/base/state.hpp"

namespace director {

State State::in(std::byte* memory, const Shape& shape) {
  State state;
  std::size_t at = 0;
  each(
      state, shape,
      [&]<class T>(T*& array, std::size_t count) {
        at = begin_of<T>(at);
        array = reinterpret_cast<T*>(memory + at); // the block's bytes become these arrays; Engine::reset fills them
        at += count * sizeof(T);
      },
      [&] { at = aligned(at, 8); });
  return state;
}

} // namespace director
