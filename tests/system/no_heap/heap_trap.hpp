#pragma once
// SPDX-License-Identifier: MIT
// Counts this thread's uses of the heap, by malloc and its like and by operator new, while it has armed a trap.

#include <cstddef>

namespace director::tests {

/// Uses since the program began, while armed.
std::size_t heap_uses();

/// The heap is watched during its lifetime; within it an Amnesty permits its use.
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
