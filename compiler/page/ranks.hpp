#pragma once
// SPDX-License-Identifier: MIT
// Who goes before whom, of any two groups: where chains of requesters to both may part, and what decides there.

#include "compiler/base/json.hpp"
#include "compiler/model/model.hpp"

#include <cstddef>

namespace director::compiler {

/// Groups of which every two are compared: what the page holds grows with the square of that.
inline constexpr std::size_t most_compared = 500;

Json ranks_json(const Model& model);

} // namespace director::compiler
