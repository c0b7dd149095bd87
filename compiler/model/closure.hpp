#pragma once
// SPDX-License-Identifier: MIT
// Which groups some groups lead to, at any depth.

#include "compiler/model/model.hpp"

#include <vector>

namespace director::compiler {

/// Adds what providers of these groups need, and so on: behind them, each once, the nearest first.
void add_needed(const Model& model, std::vector<GroupId>& groups);

/// All groups that the group's providers need, transitively; ascending, never the group itself.
std::vector<GroupId> needed_by(const Model& model, GroupId group);

/// Adds what these groups lead to by all edges: requests and needs.
void add_led_to(const Model& model, std::vector<GroupId>& groups);

} // namespace director::compiler
