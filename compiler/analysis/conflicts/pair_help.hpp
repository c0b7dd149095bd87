#pragma once
// SPDX-License-Identifier: MIT
// What to change where two members of a unit cannot always be granted together.

#include "compiler/model/model.hpp"

#include <string>

namespace director::analysis {

using namespace director::compiler;

/// Where one of the two waits for what the other one's group promises: "make `Boiler` `apart`, with a lower priority
/// than `Brew`", so that the waiting one can push it. Empty: neither does.
std::string apart_to_be_pushed(const Model& model, const Task& a, const Task& b);

} // namespace director::analysis
