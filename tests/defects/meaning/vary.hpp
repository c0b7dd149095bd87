#pragma once
// SPDX-License-Identifier: MIT
// Changes of a behaviour's text that change nothing of what it means.

#include "tests/defects/robot.hpp"

#include <set>

namespace director::defects {

/// How often each way was taken, by its name.
using Ways = std::map<std::string, std::size_t>;

/// Some of: groups, states and triggers into other files, the order of keys and lists that have none, conditions and
/// tasks in other words, other files' names, other docs.
void vary(Robot& robot, Random& random, Ways& ways);

/// Comments, empty lines and quotes.
void comment(Texts& texts, Random& random, Ways& ways);

} // namespace director::defects
