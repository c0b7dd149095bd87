#pragma once
// SPDX-License-Identifier: MIT
// What is asked of a whole behaviour: the model, its graph, and what was found out about them.

#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"

namespace director::analysis {

using namespace director::compiler; // an analysis speaks of nothing but groups, providers, states

struct Facts;
class Shared;
class Conflicts;
struct CodeInput;

/// What every check sees. The facts are computed once for all of them, and so is what is shared and what is in
/// conflict, if somebody asks.
struct Input {
  const Model& model;
  const Graph& graph;
  const Facts& facts;
  const Shared& shared;
  const Conflicts& conflicts;
};

} // namespace director::analysis
