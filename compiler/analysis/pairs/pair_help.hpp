#pragma once
// SPDX-License-Identifier: MIT
// What to change where two members of a unit cannot always be granted together.

#include "compiler/analysis/pairs/clashing_ways.hpp"

#include <string>

namespace director::analysis {

using namespace director::compiler;

/// Where one of the two waits for what the other one's group promises: "make `Boiler` `apart`, with a lower priority
/// than `Brew`", so that the waiting one can push it. Empty: neither does.
std::string apart_to_be_pushed(const Model& model, const Task& a, const Task& b);

/// What leaves each of their providers something: otherwise it would never run.
std::string propose(const Input& input, const Pack& pack, const Sides& sides, const ClashingWays& clash);

} // namespace director::analysis
