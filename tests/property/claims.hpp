#pragma once
// SPDX-License-Identifier: MIT
// Compares the answers of `why` with the state, by means of the oracle's order and plans.

#include "runtime/core/inspect/why.hpp"
#include "tests/oracle/pass.hpp"
#include "tests/property/compiled.hpp"
#include "tests/property/snapshot.hpp"

namespace director::property {

inline constexpr std::size_t kinds_of_claims = static_cast<std::size_t>(Because::Kind::limbo) + 1;

/// Checks the answer for one group: empty, or what is wrong. `notes`: of the oracle, at rest; else null.
std::string wrong_claim(const Because& claim, const View& view, const Snapshot& now, const Compiled& compiled,
                        const oracle::Parts& parts, const oracle::Notes* notes);

} // namespace director::property
