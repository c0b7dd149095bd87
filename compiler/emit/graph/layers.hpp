#pragma once
// SPDX-License-Identifier: MIT
// What of a picture stands above what.

#include "compiler/emit/graph/picture.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"

namespace director::compiler {

/// Finds bands, and which arrows go down. Boxes that nothing else of their band leads to are its first ones; where
/// boxes lead to each other in a circle, the order of the graph says where it begins. What is in no layer stands below
/// all layers where something in a layer leads to it, else above them. `bands`: false: boxes are layers, one below the
/// other.
void arrange_in_layers(const Model& model, const Graph& graph, bool bands, Picture& picture);

} // namespace director::compiler
