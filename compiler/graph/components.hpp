#pragma once
// SPDX-License-Identifier: MIT
// Finds the parts of a behaviour that are decided independently: groups that requests or needs join, or a promise of
// one that satisfies a condition of the other.

#include "compiler/model/model.hpp"

#include <cstdint>

namespace director::compiler {

/// The number of each group's component, in the order of their first groups.
IdTable<GroupId, std::uint32_t> find_components(const Model& model);

} // namespace director::compiler
