#pragma once
// SPDX-License-Identifier: MIT
// Finds the order of any two groups: where chains of requesters to both may part, and what decides there.

#include "compiler/base/json.hpp"
#include "compiler/model/model.hpp"

#include <cstddef>

namespace director::compiler {

/// Limit for the groups that are compared pairwise: the size of the page grows quadratically.
inline constexpr std::size_t most_compared = 500;

/// Limit for the pairs of requesters of one group, of all groups together. A group with which they would be more is
/// left out.
inline constexpr std::size_t most_rivals = 20'000;

/// Limit for the decisions between any two groups, counted for each pair with other ones: in dense graphs, hundreds
/// decide between two. If there are more, no two groups are compared, but for the requesters of one.
inline constexpr std::size_t most_listed = 200'000;

Json ranks_json(const Model& model, std::size_t most_decisions = most_listed);

} // namespace director::compiler
