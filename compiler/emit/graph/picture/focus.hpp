#pragma once
// SPDX-License-Identifier: MIT
// Finds the groups related to some groups: what can reach them, what they can hold, push relations, and groups with
// common needs.

#include "compiler/emit/graph/picture/picture_options.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"

namespace director::compiler {

/// All groups if there is no focus.
IdSet<GroupId> groups_in_focus(const Model& model, const Graph& graph, const PictureOptions& options);

/// Groups that are in the focus or lead to one that is; none without a focus, or where its depth is 0.
IdSet<GroupId> leading_to_focus(const Model& model, const Graph& graph, const PictureOptions& options);

/// Whether in this take-over a group in the focus may take or lose something, itself or by what it can hold. `over`:
/// what may be taken, by group.
bool is_in_focus(GroupId taker, GroupId loser, const std::vector<bool>& over, const Graph& graph,
                 const PictureOptions& options);

} // namespace director::compiler
