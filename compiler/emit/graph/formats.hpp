#pragma once
// SPDX-License-Identifier: MIT
// A picture in the formats that other programs draw or read.

#include "compiler/base/json.hpp"
#include "compiler/emit/graph/picture/picture.hpp"
#include "dsl/source/diagnostic.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace director::compiler {

/// An address with {file} and {line} in it; empty: nothing is a link.
struct PictureLinks {
  std::string pattern;
  std::string to(const PictureText& text) const;
};

/// For Graphviz: layers are bands, each group a table with a row for each provider, and a legend of what is drawn.
/// `beside`: the arrows, by index, whose label is placed after all lines, wherever there is room.
std::string dot(const Picture& picture, const PictureLinks& links = {}, const std::set<std::size_t>& beside = {});

/// The arrows, by index, whose label Graphviz left out of its output: it loses some between boxes of one rank.
std::set<std::size_t> lost_labels(const Picture& picture, const std::string& drawn);

/// Completes the output of Graphviz with bands behind the layers, and with texts for screen readers.
std::string finish_svg(const Picture& picture, const std::string& drawn);

/// A Mermaid flowchart.
std::string mermaid(const Picture& picture, const PictureLinks& links = {});

/// The input of the JSON.
struct GraphDocument {
  const Model& model;
  const Graph& graph;
  const dsl::Sources& sources;
  const PictureFlaws& flaws;
  const Moment* moment = nullptr;                         ///< null: none
  const std::vector<dsl::Diagnostic>* findings = nullptr; ///< null: they were not requested
};

/// The behaviour with everything that a picture shows or leaves out; in the order of declaration.
Json graph_json(const GraphDocument& of);

} // namespace director::compiler
