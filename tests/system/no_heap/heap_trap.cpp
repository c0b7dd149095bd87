// Header: tests/system/no_heap/heap_trap.hpp. Test: tests/system/no_heap/scenarios_test.cpp.
// SPDX-License-Identifier: MIT
//
// The C library lets a program define the allocation functions and keeps its own under other names; operator new of the
// C++ library comes down to malloc.

#include "tests/system/no_heap/heap_trap.hpp"

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

namespace {
thread_local int armed = 0;
thread_local std::size_t uses = 0;

void* counted(void* memory) {
  if (armed > 0) ++uses;
  return memory;
}
} // namespace

extern "C" {
void* malloc(std::size_t size) { return counted(__libc_malloc(size)); }
void* calloc(std::size_t count, std::size_t size) { return counted(__libc_calloc(count, size)); }
void* realloc(void* old, std::size_t size) { return counted(__libc_realloc(old, size)); }
void* aligned_alloc(std::size_t alignment, std::size_t size) { return counted(__libc_memalign(alignment, size)); }
}

namespace director::tests {

std::size_t heap_uses() { return uses; }
HeapTrap::HeapTrap() { ++armed; }
HeapTrap::~HeapTrap() { --armed; }
Amnesty::Amnesty() : depth_(armed) { armed = 0; }
Amnesty::~Amnesty() { armed = depth_; }

} // namespace director::tests
