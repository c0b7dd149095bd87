// Header: what the compiler calls for std::atomic. Test: tests/system/arm/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// A Cortex-M0 has no compare-and-swap, so the compiler calls functions of these names for the inbox. There is one core,
// so whatever no interrupt can interrupt is atomic: each is a short critical section. Loads and stores need none.
#include <cstdint>

namespace {

class CriticalSection {
public:
  CriticalSection() { asm volatile("mrs %0, primask\n\tcpsid i" : "=r"(before_)::"memory"); }
  ~CriticalSection() { asm volatile("msr primask, %0" ::"r"(before_) : "memory"); }
  CriticalSection(const CriticalSection&) = delete;
  CriticalSection& operator=(const CriticalSection&) = delete;

private:
  std::uint32_t before_;
};

template <class Change>
std::uint32_t change(volatile void* place, Change to) {
  auto& word = *static_cast<volatile std::uint32_t*>(place);
  const CriticalSection section;
  const std::uint32_t before = word;
  word = to(before);
  return before;
}

} // namespace

// The names are reserved for the compiler, so they are given as assembler names.
extern "C" {
bool compare_exchange(volatile void* place, void* expected, std::uint32_t desired, bool weak, int success,
                      int failure) asm("__atomic_compare_exchange_4");
std::uint32_t exchange(volatile void* place, std::uint32_t value, int order) asm("__atomic_exchange_4");
std::uint32_t fetch_add(volatile void* place, std::uint32_t value, int order) asm("__atomic_fetch_add_4");
std::uint32_t fetch_sub(volatile void* place, std::uint32_t value, int order) asm("__atomic_fetch_sub_4");
std::uint32_t fetch_and(volatile void* place, std::uint32_t value, int order) asm("__atomic_fetch_and_4");
std::uint32_t fetch_or(volatile void* place, std::uint32_t value, int order) asm("__atomic_fetch_or_4");
}

bool compare_exchange(volatile void* place, void* expected, std::uint32_t desired, bool, int, int) {
  auto& wanted = *static_cast<std::uint32_t*>(expected);
  const std::uint32_t before = change(place, [&](std::uint32_t now) { return now == wanted ? desired : now; });
  if (before == wanted) return true;
  wanted = before;
  return false;
}
std::uint32_t exchange(volatile void* place, std::uint32_t value, int) {
  return change(place, [&](std::uint32_t) { return value; });
}
std::uint32_t fetch_add(volatile void* place, std::uint32_t value, int) {
  return change(place, [&](std::uint32_t now) { return now + value; });
}
std::uint32_t fetch_sub(volatile void* place, std::uint32_t value, int) {
  return change(place, [&](std::uint32_t now) { return now - value; });
}
std::uint32_t fetch_and(volatile void* place, std::uint32_t value, int) {
  return change(place, [&](std::uint32_t now) { return now & value; });
}
std::uint32_t fetch_or(volatile void* place, std::uint32_t value, int) {
  return change(place, [&](std::uint32_t now) { return now | value; });
}
