#pragma once
// SPDX-License-Identifier: MIT
// What several planters build with.

#include "tests/defects/robot.hpp"

namespace director::defects {

/// A new group, and its name.
std::string make(Robot& robot, std::string_view text, const std::vector<std::string>& words = {});

/// The same as a root above all others.
std::string make_root(Robot& robot, std::string_view text, const std::vector<std::string>& words = {});

/// The first ranks before the second, which may be pushed, and both may be requested at once: by the program, or by one
/// that has both in a pack, or leads to the first.
void ask_for_both(Robot& robot, const std::string& first, const std::string& second);

/// A new state with `first` and `second`, the first at the start.
std::string make_state(Robot& robot, const std::string& first, const std::string& second);

/// A group that goes on, and can be pushed to cause that the state has the value.
std::string causer(Robot& robot, const std::string& state, const std::string& value, const std::string& before);

} // namespace director::defects
