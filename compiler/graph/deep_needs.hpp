#pragma once
// SPDX-License-Identifier: MIT
// Needs of needs of needs: a plan holds all of them at once, and whoever looks for one goes down as deep, on the stack.

#include "compiler/graph/graph.hpp"
#include "dsl/diagnostic.hpp"

#include <cstddef>
#include <vector>

namespace director::compiler {

/// A robot has five.
inline constexpr std::size_t deepest_needs = 1'000;

/// input_limit, at the first need that is deeper, however needs go around in circles. At most one finding.
std::vector<dsl::Diagnostic> too_deep_needs(const Model& model, const Graph& graph);

} // namespace director::compiler
