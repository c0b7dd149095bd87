#pragma once
// SPDX-License-Identifier: MIT
// Which groups may be brought to run otherwise than before, or go on otherwise: those whose way from the program has
// changed, or anything that they or those on the way ask for, need or wait for. Of two groups whose situations are as
// they were, the engine decides as it did, so nobody has to play it again.

#include "compiler/diff/side.hpp"

#include <set>
#include <string>

namespace director::compiler::diff {

/// By name; of those that both sides have and that ask for something or need something.
std::set<std::string> changed_situations(const Pair& pair);

} // namespace director::compiler::diff
