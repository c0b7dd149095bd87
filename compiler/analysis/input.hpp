#pragma once
// SPDX-License-Identifier: MIT
// The input of analyses of a whole behaviour: the model, its graph, and the results of other analyses.

#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"

namespace director::analysis {

using namespace director::compiler; // an analysis uses the model throughout

struct Facts;
class Shared;
class Conflicts;
struct CodeInput;

/// The input of every check. The facts are computed once for all checks; what is shared and what is in conflict is
/// computed on first use.
struct Input {
  const Model& model;
  const Graph& graph;
  const Facts& facts;
  const Shared& shared;
  const Conflicts& conflicts;
};

} // namespace director::analysis
