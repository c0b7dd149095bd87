#pragma once
// SPDX-License-Identifier: MIT
// Counts what this thread asks of the heap, by malloc and its like and by operator new, while it has armed a trap.

#include <cstddef>

namespace director::tests {

/// Asked for since the program began, while armed.
std::size_t heap_uses();

/// While one lives, the heap is watched; within it an Amnesty lets somebody else use it.
class HeapTrap {
public:
  HeapTrap();
  ~HeapTrap();
  HeapTrap(const HeapTrap&) = delete;
  HeapTrap& operator=(const HeapTrap&) = delete;
};

class Amnesty {
public:
  Amnesty();
  ~Amnesty();
  Amnesty(const Amnesty&) = delete;
  Amnesty& operator=(const Amnesty&) = delete;

private:
  int depth_;
};

} // namespace director::tests
