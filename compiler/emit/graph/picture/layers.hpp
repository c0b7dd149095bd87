#pragma once
// SPDX-License-Identifier: MIT
// Finds the vertical order of a picture.

#include "compiler/emit/graph/picture/picture.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"

namespace director::compiler {

/// Finds bands, and which arrows go down. The first boxes of a band are those that no other box of it leads to; in a
/// cycle of boxes the order of the graph decides where it begins. A box in no layer is below all layers if a box in a
/// layer leads to it, otherwise above them. `bands`: false: boxes are layers, one below the other.
void arrange_in_layers(const Model& model, const Graph& graph, bool bands, Picture& picture);

} // namespace director::compiler
