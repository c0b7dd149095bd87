#pragma once
// SPDX-License-Identifier: MIT
// Limits the depth of needs: a plan holds all of them at once, and a search for one recurses as deep.

#include "compiler/graph/graph.hpp"
#include "dsl/source/diagnostic.hpp"

#include <cstddef>
#include <vector>

namespace director::compiler {

/// A robot has five.
inline constexpr std::size_t deepest_needs = 1'000;

/// input_limit, at the first need that is deeper, whatever cycles there are. At most one finding.
std::vector<dsl::Diagnostic> too_deep_needs(const Model& model, const Graph& graph);

} // namespace director::compiler
