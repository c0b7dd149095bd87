// SPDX-License-Identifier: MIT
// On random behaviours and scenarios: each take-over that happens is one that pages list, and a point of coverage.
//
//   DIRECTOR_SEED, DIRECTOR_CASES   as in property_test.cpp
#include "compiler/play/coverage/coverage.hpp"
#include "compiler/play/coverage/coverage_watch.hpp"
#include "tests/property/engine_run.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/watch.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <iostream>
#include <set>

namespace {

using namespace director::property;
using director::compiler::Coverage;
using director::compiler::CoveragePoint;
using director::compiler::EdgeId;

/// As if each two edges of one requester were a point.
Coverage all_take_overs(const director::compiler::Model& model) {
  Coverage out;
  for (const EdgeId first : model.edges.ids()) {
    for (const EdgeId second : model.edges.ids()) {
      if (first == second || model.edges[first].requester != model.edges[second].requester) continue;
      out.points.push_back({{CoveragePoint::Kind::take_over, first.value, second.value}, {}, false});
    }
  }
  return out;
}

struct Counts {
  std::uint64_t happened = 0, listed = 0;
};

/// Whether a scenario begins where no other one comes to.
bool begins_elsewhere(const Compiled& compiled) {
  const auto& given = compiled.scenario.given;
  return std::any_of(given.begin(), given.end(),
                     [&](const auto& each) { return !compiled.model.states[each.state].external; });
}

/// What runs only while a provider is disabled is not counted.
bool disables(const director::compiler::ScenarioStep& step) {
  return std::any_of(step.inputs.begin(), step.inputs.end(),
                     [](const auto& input) { return input.kind == director::dsl::InputSpec::Kind::disable; });
}

/// Whether some pack has both as members of one unit. Then what the one needs may pass to the other, whatever their
/// ranks, as a plan is chosen for both.
bool may_be_mates(const director::compiler::Model& model, EdgeId first, EdgeId second) {
  const auto has = [&](const director::compiler::Pack& pack, EdgeId edge) {
    return std::any_of(pack.tasks.begin(), pack.tasks.end(), [&](const director::compiler::Task& task) {
      return task.edge == edge && std::any_of(task.levels.begin(), task.levels.end(), [&](const auto& level) {
               return model.edges[edge].levels[level.level].shares_unit();
             });
    });
  };
  return std::any_of(model.providers.begin(), model.providers.end(), [&](const auto& provider) {
    return std::any_of(provider.packs.begin(), provider.packs.end(),
                       [&](const auto& pack) { return has(pack, first) && has(pack, second); });
  });
}

/// Those that happen and are not listed, a line each.
std::string find_unlisted(const Compiled& compiled, Counts& counts) {
  const director::compiler::Model& model = compiled.model;
  std::set<CoveragePoint::Key> listed;
  for (const CoveragePoint& point :
       director::compiler::coverage_of(model, director::compiler::make_graph(model)).points)
    if (point.key.kind == CoveragePoint::Kind::take_over) listed.insert(point.key);
  Coverage happened = all_take_overs(model);
  director::compiler::CoverageWatch watch(model, compiled.lowered, happened);
  const director::compiler::Onlooker onlooker = watch.onlooker();
  EngineRun run(compiled, false);
  for (const auto& step : compiled.scenario.steps) {
    if (disables(step)) break;
    run.begin_step(step);
    while (run.micro_step()) onlooker.stepped(run.engine());
    onlooker.stepped(run.engine());
  }
  std::string out;
  counts.listed += listed.size();
  for (const CoveragePoint& point : happened.points) {
    if (!point.covered) continue;
    ++counts.happened;
    if (listed.contains(point.key) || may_be_mates(model, EdgeId{point.key.first}, EdgeId{point.key.second})) continue;
    out +=
        "  " + model.edge_name(EdgeId{point.key.first}) + " from " + model.edge_name(EdgeId{point.key.second}) + "\n";
  }
  return out;
}

void find_all(Documents (*make)(std::uint64_t), std::uint64_t cases) {
  const auto first = director::tests::from_environment<std::uint64_t>("DIRECTOR_SEED", 1);
  Counts counts;
  std::string unlisted;
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    watch(seed);
    const Documents documents = make(seed);
    const CompileResult result = compile(to_yaml(documents.behaviour), to_yaml(documents.scenario));
    INFO("DIRECTOR_SEED=" << seed << " " << result.why);
    REQUIRE(result.compiled);
    const std::string some = begins_elsewhere(*result.compiled) ? "" : find_unlisted(*result.compiled, counts);
    stop_watching();
    if (!some.empty()) unlisted += "DIRECTOR_SEED=" + std::to_string(seed) + "\n" + some;
  }
  std::cout << cases << " cases, " << counts.happened << " take-overs happened, " << counts.listed << " are listed\n";
  CHECK(unlisted == "");
  if (cases >= 250) CHECK(counts.happened > cases / 10);
}

TEST_CASE("each take-over that happens is listed") {
  find_all(generate, director::tests::cases_of({.usual = 1'000, .slow = 50}));
}

TEST_CASE("each take-over that happens is listed if a unit changes its place in the order") {
  find_all(generate_moving_unit, director::tests::cases_of({.usual = 500, .slow = 25}));
}

} // namespace
