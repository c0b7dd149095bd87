#pragma once
// SPDX-License-Identifier: MIT
// Cases that grow.

#include "tests/bench/case.hpp"

#include <vector>

namespace bench {

void add_grown_cases(std::vector<Entry>& entries);

} // namespace bench
