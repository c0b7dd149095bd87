#pragma once
// SPDX-License-Identifier: MIT
// What a page has beside the picture of a behaviour: which task takes groups from which, whether the assertions are
// true, and the transition matrix. All of it is in the JSON that `directorc graph --format=json --page` prints; the
// pages are made from that alone.

#include "compiler/base/json.hpp"
#include "compiler/emit/graph/picture/picture_options.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"
#include "compiler/play/coverage/coverage.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace director::compiler {

struct Verdict;

/// Limit for the take-overs in a page: tasks that all want the same have quadratically many.
inline constexpr std::size_t most_takes = 20'000;

/// The possible take-overs; both edges are of one requester. With more than `limits.most`, one more than that.
std::vector<TakeOver> take_overs_of(const Model& model, const Graph& graph, const TakeLimits& limits);

/// Without promises that no task can push for: no waiting task goes before the causing group, or none ever waits. The
/// behaviour must be able to run.
Graph with_possible_pushes(const Model& model, Graph graph);

/// Adds `pushes`, `takes`, `takes_left_out` if there are too many, `ranks`, `verdicts` and `transitions` to the result
/// of graph_json(). The behaviour must be able to run. `file`: its path in scenarios. `transitions`: only of these
/// groups; empty: of all. `verdicts`: of the assertions; null: they are decided here.
void add_page_facts(Json& data, const Model& model, const Graph& graph, const std::string& file,
                    const std::vector<GroupId>& transitions = {}, const std::vector<Verdict>* verdicts = nullptr);

} // namespace director::compiler
