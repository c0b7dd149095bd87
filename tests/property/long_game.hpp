#pragma once
// SPDX-License-Identifier: MIT
// Long games of behaviours of any size, each played twice: with incremental passes, and with passes from nothing. After
// every micro-step both must have decided the same, including the order of groups and events. The oracle, which
// enumerates all plans, is too slow for these. Inputs are random, and so are the requests, values and answers of each
// run.

#include "tests/property/compiled.hpp"

#include <cstdint>
#include <string>

namespace director::property {

/// The first difference, and its place; nothing: both decide the same to the end. `micro_steps` grows by those that
/// were compared.
std::string decided_otherwise(const Compiled& compiled, std::uint64_t seed, std::uint64_t& micro_steps);

} // namespace director::property
