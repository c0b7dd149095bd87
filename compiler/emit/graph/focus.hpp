#pragma once
// SPDX-License-Identifier: MIT
// What has to do with some groups: who can reach them, what they can hold, whom they may push and who them, and who
// needs what they need.

#include "compiler/emit/graph/picture_options.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"

namespace director::compiler {

/// Every group where there is no focus.
IdSet<GroupId> groups_in_focus(const Model& model, const Graph& graph, const PictureOptions& options);

} // namespace director::compiler
