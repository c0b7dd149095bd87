#pragma once
// SPDX-License-Identifier: MIT
// Long games of behaviours of any size, each played twice: once a pass decides again what a change reaches, once all.
// After every micro-step both must have decided the same, the order of groups and what an observer is told included.
// The oracle, which writes out all plans, is too slow for these. Inputs are at random, and so is in each run what a
// body asks for, sets and answers.

#include "tests/property/compiled.hpp"

#include <cstdint>
#include <string>

namespace director::property {

/// What differs, and where; nothing: both decide the same to the end. `micro_steps` grows by those that were compared.
std::string decided_otherwise(const Compiled& compiled, std::uint64_t seed, std::uint64_t& micro_steps);

} // namespace director::property
