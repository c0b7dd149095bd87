// Header: tests/system/arm/target/board.hpp. Test: tests/system/arm/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// Start-up of a Cortex-M: the vector table, memory as the language expects it, main. Unused stack keeps the pattern
// that it is filled with. Semihosting: "Semihosting for AArch32 and AArch64", Arm.
#include "tests/system/arm/target/board.hpp"

#include <cstdint>

extern "C" {
// Of the linker script.
extern std::uint32_t stack_limit[], stack_top[], data_begin[], data_end[], data_image[], bss_begin[], bss_end[];
extern void (*init_begin[])(), (*init_end[])();
void start();
}

namespace target {

namespace {

constexpr std::uint32_t unused = 0xa5a5a5a5;

int call(int operation, const void* argument) {
  register int r0 asm("r0") = operation;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

void fault() {
  print("a fault of the processor\n");
  finish(3);
}

using Vector = void (*)();
struct Vectors {
  std::uint32_t* stack;
  Vector handlers[15];
};

[[gnu::section(".vectors"), gnu::used]] constinit const Vectors vectors{stack_top,
                                                                        {start, fault, fault, fault, fault, fault,
                                                                         nullptr, nullptr, nullptr, nullptr, fault,
                                                                         fault, nullptr, fault, fault}};

} // namespace

void print(const char* text) { call(0x04, text); } // SYS_WRITE0

void finish(int status) {
  const std::uint32_t block[2]{0x20026, static_cast<std::uint32_t>(status)}; // ADP_Stopped_ApplicationExit
  for (;;) call(0x20, block);                                                // SYS_EXIT_EXTENDED
}

std::size_t deepest_stack() {
  const std::uint32_t* at = stack_limit;
  while (at != stack_top && *at == unused) ++at;
  return static_cast<std::size_t>(stack_top - at) * sizeof *at;
}

} // namespace target

extern "C" void start() {
  std::uint32_t* here = nullptr;
  asm volatile("mov %0, sp" : "=r"(here));
  for (std::uint32_t* at = stack_limit; at < here - 16; ++at) *at = target::unused;
  for (std::uint32_t *from = data_image, *to = data_begin; to != data_end;) *to++ = *from++;
  for (std::uint32_t* at = bss_begin; at != bss_end;) *at++ = 0;
  for (auto* each = init_begin; each != init_end; ++each) (*each)();
  target::finish(main());
}
