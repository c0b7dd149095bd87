#pragma once
// SPDX-License-Identifier: MIT
// Two buffers between one writer and any number of readers, in any threads: the writer fills one while readers may be
// in the other. Nobody waits for anybody. Needs what the inbox needs.

#include "runtime/core/base/tables.hpp"

#include <atomic>
#include <cstdint>

namespace director {

class DoubleBuffer {
public:
  // The writer's.
  Index begin(); ///< a buffer to write into; nil: somebody is still in the older one, and this time is left out
  void finish(Index buffer); ///< from now on readers enter this one

  // The readers'.
  Index enter(); ///< the buffer that was finished last; nil: none was, or 255 readers are in it
  void leave(Index buffer);

private:
  std::atomic<std::uint32_t> state_{
      0}; ///< bits 0-1: 0, or one more than the buffer to enter; a byte for each buffer's readers
};

} // namespace director
