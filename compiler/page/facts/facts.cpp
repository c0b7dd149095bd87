// Header: compiler/page/facts/facts.hpp. Test: tests/compiler/page/facts/facts_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/page/facts/facts.hpp"

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/facts/pushes.hpp"
#include "compiler/emit/graph/picture/take_ranks.hpp"
#include "compiler/explore/limits.hpp"
#include "compiler/explore/verdict.hpp"
#include "compiler/graph/algorithms.hpp"
#include "compiler/graph/topmost.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/page/facts/ranks.hpp"
#include "compiler/page/facts/ruling.hpp"
#include "compiler/play/coverage/coverage.hpp"
#include "compiler/transitions/transitions_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

namespace director::compiler {

namespace {

Json priorities_json(const std::set<std::int32_t>& all) {
  Json out = Json::list({});
  for (const std::int32_t priority : all) out.add(Json::number(priority));
  return out;
}

/// Of the ranks by which the one may take from the other: each priority once.
std::set<std::int32_t> priorities(const std::set<analysis::Winning>& ranks,
                                  analysis::SideRank analysis::Winning::*side) {
  std::set<std::int32_t> all;
  for (const analysis::Winning& each : ranks) all.insert((each.*side).priority);
  return all;
}

bool by_optional(const analysis::Winning& ranks) { return ranks.second.optional && !ranks.first.optional; }

bool is_optional_at(const Edge& edge, std::int32_t priority) {
  return std::any_of(edge.levels.begin(), edge.levels.end(),
                     [&](const Level& level) { return level.optional && level.priority == priority; });
}

/// `Grip is granted together with Lift (priority 50)`
std::string led_words(const Model& model, EdgeId member, const std::set<Leader>& leaders) {
  return fmt::format("{} is {}", model.groups[model.edges[member].target].name.value,
                     together_words(model, {leaders.begin(), leaders.end()}));
}

/// `priority 80 before 20`, `where the second is optional`
std::string words_of(const PossibleTake& take, const Model& model, const std::set<analysis::Winning>& by_priority) {
  const Edge &taker = model.edges[take.taker], &loser = model.edges[take.loser];
  std::vector<std::string> out;
  if (!by_priority.empty()) {
    const std::vector<std::string> all = ranks_words(taker, loser, by_priority, "before");
    out.push_back(fmt::format("priority {}{}", fmt::join(all, ", or "),
                              take.except.empty() ? "" : ", unless " + led_words(model, take.loser, take.except)));
  }
  bool itself = false, below = false;
  for (const analysis::Winning& each : take.ranks) {
    if (!by_optional(each)) continue;
    (is_optional_at(loser, each.second.priority) ? itself : below) = true;
  }
  if (itself) out.emplace_back("where the second is optional");
  if (below) out.emplace_back("where something below the second is optional");
  if (!take.leaders.empty()) out.push_back("where " + led_words(model, take.taker, take.leaders));
  return fmt::format("{}", fmt::join(out, ", or "));
}

Json take_json(const PossibleTake& take, const Model& model, Topmost& topmost) {
  const Edge &taker = model.edges[take.taker], &loser = model.edges[take.loser];
  Json out = Json::object({});
  if (taker.requester) out.add("requester", Json::text(model.groups[*taker.requester].name.value));
  out.add("winner", Json::text(model.groups[taker.target].name.value));
  out.add("loser", Json::text(model.groups[loser.target].name.value));
  std::set<analysis::Winning> by_priority = take.ranks;
  std::erase_if(by_priority, by_optional);
  const bool is_ranked = !by_priority.empty();
  out.add("by", Json::text(is_ranked ? "priority" : take.ranks.empty() ? "unit" : "optional"));
  std::set<std::int32_t> winners = priorities(is_ranked ? by_priority : take.ranks, &analysis::Winning::first),
                         losers = priorities(is_ranked ? by_priority : take.ranks, &analysis::Winning::second);
  if (take.ranks.empty()) {
    for (const Leader& leader : take.leaders) winners.insert(leader.priority);
    losers = take.led_over;
  }
  out.add("winner_priorities", priorities_json(winners));
  out.add("loser_priorities", priorities_json(losers));
  out.add("words", Json::text(words_of(take, model, by_priority)));
  Json over = Json::list({});
  for (const GroupId id : topmost.of(taker.target, loser.target, take.groups))
    over.add(Json::text(model.groups[id].name.value));
  out.add("over", std::move(over));
  return out;
}

Json verdicts_json(const std::vector<Verdict>& verdicts, const Model& model) {
  Json out = Json::list({});
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    Json row = Json::object({{"assertion", Json::text(words_of(model.assertions[i], model))},
                             {"verdict", Json::text(name_of(verdicts[i].kind))},
                             {"why", Json::text(verdicts[i].why)}});
    if (verdicts[i].scenario) row.add("scenario", Json::text(*verdicts[i].scenario));
    out.add(std::move(row));
  }
  return out;
}

/// A cell is one course of events, and the assertion `soft` is about all of them.
void add_verdicts(const std::vector<Verdict>& verdicts, const Model& model, TransitionMatrix& matrix) {
  const auto place = [&](GroupId id) {
    const auto at = std::find_if(matrix.rows.begin(), matrix.rows.end(),
                                 [&](const TransitionMatrix::Row& row) { return row.group == id; });
    return static_cast<std::size_t>(at - matrix.rows.begin());
  };
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const Assertion& assertion = model.assertions[i];
    if (assertion.kind != Assertion::Kind::soft) continue;
    const std::size_t from = place(assertion.groups[0].id), to = place(assertion.groups[1].id);
    if (from == matrix.rows.size() || to == matrix.rows.size()) continue;
    Transition& cell = matrix.rows[from].cells[to];
    if (!cell.asserted.empty()) continue; // asserted twice
    cell.asserted = name_of(verdicts[i].kind);
    cell.words += fmt::format(" It is asserted that granting {} is soft for {}: {}.",
                              model.groups[assertion.groups[1].id].name.value,
                              model.groups[assertion.groups[0].id].name.value, cell.asserted);
  }
}

} // namespace

std::vector<TakeOver> take_overs_of(const Model& model, const Graph& graph, const TakeLimits& limits) {
  std::vector<TakeOver> out;
  for (const PossibleTake& take : possible_takes(model, graph, limits)) {
    if (!take.ranks.empty()) out.push_back({take.taker, take.loser, take.ranks, take.groups});
  }
  return out;
}

Graph with_possible_pushes(const Model& model, Graph graph) {
  const auto all = analysis::find_all_pushes(
      model, analysis::find_facts(model, graph, analysis::Reported::as_is)); // also through others
  IdTable<ProviderId, std::vector<GroupId>> tasks(model.providers.size());
  IdTable<GroupId, std::vector<bool>> plans(model.groups.size()); // what it may wait for: conditions of its needs too
  for (const auto& [task, causer] : all) {
    tasks[causer].push_back(task); // in order
    if (!plans[task].empty()) continue;
    plans[task] = reachable(graph.needs, task.value);
    plans[task][task.value] = true;
  }
  std::erase_if(graph.causing, [&](const Graph::Causing& row) {
    return std::none_of(tasks[row.causer].begin(), tasks[row.causer].end(), [&](GroupId task) {
      const std::vector<GroupId>& pushed_by = tasks[row.waiter];
      return plans[task][model.providers[row.waiter].group.value] ||
             std::binary_search(pushed_by.begin(), pushed_by.end(), task);
    });
  });
  return graph;
}

void add_page_facts(Json& data, const Model& model, const Graph& graph, const std::string& file,
                    const std::vector<GroupId>& transitions, const std::vector<Verdict>* verdicts) {
  const Lowered lowered = lower(model);
  Json pushes = Json::list({});
  for (const Graph::Causing& row : with_possible_pushes(model, graph).causing) {
    pushes.add(Json::object({{"waiter", Json::text(model.distinct_name(row.waiter))},
                             {"condition", Json::text(model.conditions[row.condition.id].text)},
                             {"causer", Json::text(model.distinct_name(row.causer))}}));
  }
  data.add("pushes", std::move(pushes));
  Json takes = Json::list({});
  Topmost topmost(graph);
  const std::vector<PossibleTake> possible = possible_takes(model, graph, {most_takes, {}});
  const bool too_many = possible.size() > most_takes;
  for (std::size_t i = 0; i < possible.size() && !too_many; ++i) takes.add(take_json(possible[i], model, topmost));
  data.add("takes", std::move(takes));
  if (too_many) {
    data.add("takes_left_out",
             Json::text(fmt::format("What tasks may take from each other is not listed here, as there are more than {} "
                                    "pairs of them; `directorc graph --view=takes --focus GROUP --depth 1` "
                                    "draws those of a group.",
                                    most_takes)));
  }
  data.add("ranks", ranks_json(model));
  std::vector<Verdict> decided;
  if (verdicts == nullptr && !model.assertions.empty())
    decided = decide_assertions(Ground(model, lowered), states_of_check);
  const std::vector<Verdict>& all = verdicts == nullptr ? decided : *verdicts;
  data.add("verdicts", verdicts_json(all, model));
  TransitionMatrix matrix = find_transitions(model, lowered, file, transitions);
  add_verdicts(all, model, matrix);
  data.add("transitions", transitions_json(matrix, model));
}

} // namespace director::compiler
