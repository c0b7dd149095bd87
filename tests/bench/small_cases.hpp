#pragma once
// SPDX-License-Identifier: MIT
// Cases with the API that directorc generates, from the files of tests/bench/behaviours, and their floors.

#include "tests/bench/case.hpp"

#include <vector>

namespace bench {

void add_small_cases(std::vector<Entry>& entries);

} // namespace bench
