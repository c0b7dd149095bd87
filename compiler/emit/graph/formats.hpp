#pragma once
// SPDX-License-Identifier: MIT
// A picture in the formats that other programs draw or read.

#include "compiler/emit/graph/picture.hpp"
#include "compiler/base/json.hpp"

#include <string>

namespace director::compiler {

/// For Graphviz: layers are ranks, each group a table with a row for each provider, and a legend.
std::string dot(const Picture& picture);

/// A Mermaid flowchart.
std::string mermaid(const Picture& picture);

/// The behaviour's graph with everything that the picture leaves out: packs, levels, modules, handlers.
Json graph_json(const Model& model, const Graph& graph);

} // namespace director::compiler
