#pragma once
// SPDX-License-Identifier: MIT
// Properties that hold after every micro-step of any behaviour, tested on the state of the engine.

#include "tests/property/snapshot.hpp"

namespace director::property {

/// Empty if all of them hold. `at_rest`: the step is over.
std::string broken_invariant(const Snapshot& now, const oracle::Parts& parts, bool at_rest);

} // namespace director::property
