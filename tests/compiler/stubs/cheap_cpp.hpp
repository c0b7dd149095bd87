#pragma once
// SPDX-License-Identifier: MIT
// A cheap stand-in for Clang: understands as much C++ as the tests of stubs write, by its tokens alone, in microseconds
// instead of a tenth of a second. That it says the same as Clang of the same texts is a test of the stage `clang`.
// Contexts are written with their whole names; what stands under `#if 0` is not seen; other conditions count as true.

#include "compiler/stubs/found.hpp"
#include "compiler/stubs/insertion.hpp"
#include "compiler/stubs/wanted.hpp"

namespace director::tests {

compiler::stubs::Found read_cheaply(const compiler::stubs::Texts& texts, const compiler::stubs::Wanted& wanted);

} // namespace director::tests
