#pragma once
// SPDX-License-Identifier: MIT
// Which groups some groups lead to, at any depth.

#include "compiler/model/model.hpp"

#include <vector>

namespace director::compiler {

/// Adds what providers of these groups need, and so on: behind them, each once, the nearest first.
void add_needed(const Model& model, std::vector<GroupId>& groups);

/// The same by all edges: requests and needs.
void add_led_to(const Model& model, std::vector<GroupId>& groups);

} // namespace director::compiler
