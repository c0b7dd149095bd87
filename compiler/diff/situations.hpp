#pragma once
// SPDX-License-Identifier: MIT
// Finds the groups that may be brought to run, or may continue, differently than before: their chain from the program
// has changed, or anything that they or the groups on the chain request, need or wait for. For two groups with
// unchanged situations the engine decides as before, so they need not be played again.

#include "compiler/diff/side.hpp"

#include <set>
#include <string>

namespace director::compiler::diff {

/// By name; the groups on both sides that request or need something.
std::set<std::string> changed_situations(const Pair& pair);

} // namespace director::compiler::diff
