#pragma once
// SPDX-License-Identifier: MIT
// Which tasks of one requester can stand in each other's way: those that can claim the same group, by their targets and
// all that the plans of these may contain, directly or by way of others. The engine combines the choices of such tasks,
// and chooses for all others one by one.

#include "compiler/model/model.hpp"

namespace director::compiler {

/// Of each edge that can be requested, the first one of its requester that it is in a cluster with; itself where there
/// is none.
IdTable<EdgeId, EdgeId> find_clusters(const Model& model);

} // namespace director::compiler
