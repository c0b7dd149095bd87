#pragma once
// SPDX-License-Identifier: MIT
// Finds which tasks of one requester can conflict: those that can claim the same group, by their targets and all that
// their plans may contain, directly or through others. The engine combines the choices of such tasks, and chooses all
// others one by one.

#include "compiler/model/model.hpp"

namespace director::compiler {

/// For each edge that can be requested, the first one of its requester in the same cluster; itself if there is none.
IdTable<EdgeId, EdgeId> find_clusters(const Model& model);

} // namespace director::compiler
