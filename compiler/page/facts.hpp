#pragma once
// SPDX-License-Identifier: MIT
// What a page tells of a behaviour and its picture does not: who beats whom, whether the assertions are true, and the
// transition matrix. All of it goes into the JSON that `directorc graph --format=json --page` prints; the pages are
// written from that and from nothing else.

#include "compiler/base/json.hpp"
#include "compiler/emit/graph/picture_options.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"

#include <string>
#include <vector>

namespace director::compiler {

/// Of all that can happen, which tasks may take something from which; both of one requester.
std::vector<TakeOver> take_overs_of(const Model& model, const Graph& graph);

/// Without the promises that no task can push for: it never goes before the group that gives them, or never waits for
/// them. The behaviour must be one that can run.
Graph with_possible_pushes(const Model& model, Graph graph);

/// Adds `pushes`, `takes`, `ranks`, `verdicts` and `transitions` to what graph_json() made. The behaviour must be one
/// that can run. `file`: what scenarios call it. `transitions`: of these groups only; empty: of all.
void add_page_facts(Json& data, const Model& model, const Graph& graph, const std::string& file,
                    const std::vector<GroupId>& transitions = {});

} // namespace director::compiler
