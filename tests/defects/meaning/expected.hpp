#pragma once
// SPDX-License-Identifier: MIT
// What each defect changes: kinds of `directorc diff`, any of which names it.

#include "tests/defects/planter.hpp"

#include <set>
#include <string>

namespace director::defects {

/// By what a planter does. Empty: nothing of a behaviour, only a scenario; nothing is told then.
const std::set<std::string>& expected_kinds(const Planter& planter);

} // namespace director::defects
