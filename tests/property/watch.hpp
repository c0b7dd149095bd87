#pragma once
// SPDX-License-Identifier: MIT
// Says which case was in hand when the program dies or hangs: a test that runs thousands must not keep that to itself.

#include <cstdint>

namespace director::property {

/// From now on this seed is in hand. It is given a minute.
void watch(std::uint64_t seed);
/// No case is in hand any more.
void stop_watching();

} // namespace director::property
