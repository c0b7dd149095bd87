#pragma once
// SPDX-License-Identifier: MIT
// The matrix as JSON. Schema: `transitions` of schemas/graph.schema.json.

#include "compiler/base/json.hpp"
#include "compiler/transitions/matrix.hpp"

namespace director::compiler {

Json transitions_json(const TransitionMatrix& matrix, const Model& model);

} // namespace director::compiler
