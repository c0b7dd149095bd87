#pragma once
// SPDX-License-Identifier: MIT
// A cheap stand-in for Clang: parses as much C++ as the tests of stubs write, by its tokens alone, in microseconds
// instead of a tenth of a second. A test of the stage `clang` compares it with Clang on the same texts. Contexts are
// written with their whole names; what is under `#if 0` is skipped; other conditions count as true.

#include "compiler/stubs/found.hpp"
#include "compiler/stubs/insertion.hpp"
#include "compiler/stubs/wanted.hpp"

namespace director::tests {

compiler::stubs::Found read_cheaply(const compiler::stubs::Texts& texts, const compiler::stubs::Wanted& wanted);

} // namespace director::tests
