#pragma once
// SPDX-License-Identifier: MIT
// What holds after every micro-step, whatever the behaviour: looked for in what the engine says of itself.

#include "tests/property/snapshot.hpp"

namespace director::property {

/// Empty if all is well. `at_rest`: the step is over.
std::string broken_invariant(const Snapshot& now, const oracle::Parts& parts, bool at_rest);

} // namespace director::property
