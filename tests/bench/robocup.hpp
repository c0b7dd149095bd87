#pragma once
// SPDX-License-Identifier: MIT
// behaviours/robocup plays by a script: what a robot's senses and a referee say, and bodies that take turns in what
// their providers may ask for.

#include "tests/bench/case.hpp"

#include <vector>

namespace bench {

void add_robocup(std::vector<Entry>& entries);

} // namespace bench
