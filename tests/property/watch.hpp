#pragma once
// SPDX-License-Identifier: MIT
// Prints the current case when the program dies or hangs, for tests that run thousands of cases.

#include <cstdint>

namespace director::property {

/// Sets the current seed, for which a minute is allowed.
void watch(std::uint64_t seed);
/// Ends the current case.
void stop_watching();

} // namespace director::property
