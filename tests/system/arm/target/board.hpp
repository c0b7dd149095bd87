#pragma once
// SPDX-License-Identifier: MIT
// What the programs of this folder need of the board: output and exit, by semihosting, and the depth of the stack.

#include <cstddef>

namespace target {

void print(const char* text);
[[noreturn]] void finish(int status);

/// Bytes of stack that were ever in use.
std::size_t deepest_stack();

} // namespace target

/// Written by each program; its answer is the exit code.
int main();
