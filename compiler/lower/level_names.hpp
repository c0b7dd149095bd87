#pragma once
// SPDX-License-Identifier: MIT
// What the rows of Tables::levels are called.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"

#include <string>
#include <vector>

namespace director::compiler {

/// Of the rows of all edges, one after another; empty for the first of a task. What one pack calls its level another
/// may call otherwise: the first counts.
std::vector<std::string> level_names(const Model& model, const Lowered& lowered);

} // namespace director::compiler
