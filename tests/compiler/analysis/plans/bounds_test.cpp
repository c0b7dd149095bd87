// SPDX-License-Identifier: MIT
#include "compiler/analysis/plans/bounds.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/pipeline.hpp"
#include "compiler/play/play.hpp"
#include "compiler/play/scenario/resolve_scenario.hpp"
#include "dsl/reading/read_scenario.hpp"
#include "tests/compiler/support/compiled.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <map>

namespace {

using namespace director;
using namespace director::analysis;

Bounds bounds_of(const std::string& text) {
  const auto compiled = tests::compile("behaviour: test\nlanguage: 1\n" + text);
  return find_bounds(compiled.model, lower(compiled.model).view());
}

TEST_CASE("each number of a small behaviour") {
  const Bounds bounds = bounds_of(R"(
states: {Pose: {values: [a, b], initial: a, external: true}}
roots: [Both]
groups:
  Both:
    tasks: {Left: {}, Right: {}, Look: {optional: true}}
  Left: {providers: [{name: one, needs: [Arm]}, {name: two, needs: [Leg]}]}
  Right: {providers: [{name: one, needs: [Arm]}, {name: two, needs: [Leg]}, {name: three}]}
  Look: {}
  Arm: {}
  Leg: {}
)");
  constexpr int unit = 2 * (2 + 3) + 2 * 3; // Left and Right: one by one, each by itself, and together
  CHECK(bounds.trials == unit);
  CHECK(bounds.trials_in_a_pass == 2 * 1 + (2 * unit + 2 * 2 + 2 * 3 + 2 * 1)); // the root; the unit, and each alone
  CHECK(bounds.repetitions == 2);                                               // Arm and Leg have two requesters
  CHECK(bounds.runs_waiting == 6);
  CHECK(bounds.to_first_run == 7);
  CHECK(bounds.calm_input == 7);
  CHECK(bounds.counted);
  CHECK_FALSE(bounds.handlers_set);
  CHECK(bounds.decision_bytes < bounds.engine_bytes);
}

TEST_CASE("of a group only the worst of its packs counts, and what is optional at one level counts as both") {
  const Bounds bounds = bounds_of(R"(
roots: [A]
groups:
  A:
    stop: {sets: []}
    packs:
      small: [B]
      large: {B: {levels: {firm: {}, spare: {optional: true}}}, C: {}}
  B: {providers: [{name: one}, {name: two}]}
  C: {}
)");
  constexpr int unit = 2 * (2 + 1); // B and C claim nothing that the other one does
  CHECK(bounds.trials == unit);
  CHECK(bounds.trials_in_a_pass == 2 * 1 + (2 * unit + 2 * 2 + 2 * 1));
  CHECK_FALSE(bounds.handlers_set);
}

TEST_CASE("a pass is over one component, and the worst of them counts") {
  const Bounds bounds = bounds_of(R"(
states: {Pose: {values: [a, b], initial: a}}
roots: [A, B, C]
groups:
  A: {}
  B: {providers: [{name: one, when: [Pose == b]}, {name: two}]}
  C: {providers: [{name: one, causing: [Pose == b]}, {name: two}, {name: three}]}
)");
  CHECK(bounds.trials == 3);
  CHECK(bounds.trials_in_a_pass == 2 * 2 + 2 * 3); // C may be pushed for B
}

TEST_CASE("a handler that sets, and a state of a group, cause inputs of their own") {
  CHECK(
      bounds_of("states: {S: {values: [a], initial: a}}\nroots: [A]\ngroups: {A: {stop: {sets: [S]}}}\n").handlers_set);
  CHECK(
      bounds_of("states: {S: {values: [a], initial: a, of: A}}\nroots: [A]\ngroups: {A: {sets: [S]}}\n").handlers_set);
}

/// A member decided alone: all its choices twice, or four times if an equal may deny it something; a choice is an
/// examined provider and a plan that is found and left.
constexpr std::int64_t alone(std::int64_t providers, std::int64_t plans, int scans = 1) {
  return scans * 2 * (providers + 2 * plans);
}

TEST_CASE("one task: its group is placed, its edge decided, and its provider tried") {
  const Bounds bounds = bounds_of("roots: [A]\ngroups: {A: {}}\n");
  CHECK(bounds.work_in_a_pass == 1 + 1 + alone(1, 1));
  CHECK(bounds.work_in_a_micro_step == bounds.work_in_a_pass);
}

TEST_CASE("components add up in a micro-step, and the dearest counts in a pass") {
  const Bounds bounds = bounds_of("roots: [A, B]\ngroups: {A: {}, B: {providers: [{name: one}, {name: two}]}}\n");
  CHECK(bounds.work_in_a_pass == 1 + 1 + alone(2, 2));
  CHECK(bounds.work_in_a_micro_step == bounds.work_in_a_pass + 1 + 1 + alone(1, 1));
}

TEST_CASE("a pack costs its members alone, and together in all combinations of what can collide; a pass is repeated "
          "for what two equals can request") {
  const Bounds bounds = bounds_of(R"(
roots: [Both]
groups:
  Both: {tasks: [Left, Right]}
  Left: {providers: [{name: one, needs: [Arm]}, {name: two, needs: [Leg]}]}
  Right: {providers: [{name: one, needs: [Arm]}, {name: two, needs: [Leg]}, {name: three}]}
  Arm: {}
  Leg: {}
)");
  constexpr std::int64_t left = 2 + 2 * 2, right = 3 + 2 * 3; // their choices
  constexpr std::int64_t unit = 2 * (2 * (left + right) + left + 2 * right);
  constexpr std::int64_t edges = 7;                              // root to Both, to Left and Right, and four needs
  constexpr std::int64_t sweep = 5 + edges + alone(1, 1) + unit; // Left and Right are equal, and Both is not
  CHECK(bounds.work_in_a_pass == (1 + 2) * sweep);               // Arm and Leg
}

TEST_CASE("a task that waits for a condition searches all that may make it true, once more than there are conditions, "
          "and once for nothing") {
  const Bounds bounds = bounds_of(R"(
states: {Pose: {values: [a, b], initial: a}, Hat: {values: [off, on], initial: off}}
roots: [A, B, C]
groups:
  A: {when: [Pose == b]}
  B: {providers: [{name: one, when: [Hat == on], causing: [Pose == b]}, {name: two}]}
  C: {providers: [{name: one, causing: [Hat == on]}, {name: two}]}
)");
  constexpr std::int64_t hat = (1 + 2) * 1, pose = (2 + 2) * 2; // conditions and rounds, plans of their causing
                                                                // providers
  CHECK(bounds.work_in_a_pass == 3 + 3 + alone(1, 1) + pose + alone(2, 2) + hat + alone(2, 2));
}

/// Root tasks that were granted at once, and how long each waits for its run.
class FirstRuns {
public:
  explicit FirstRuns(const Model& model) : model_(model) {}

  compiler::Onlooker onlooker() {
    return {[this](ProviderId provider, const compiler::Case*) { ran_ = model_.providers[provider].group; },
            [this](const Engine& engine) { look(engine); }};
  }
  std::size_t measured = 0;
  std::int64_t longest = 0;

private:
  void look(const Engine& engine) {
    const std::uint64_t now = engine.memory().counters->micro_step;
    const Tables& tables = engine.tables();
    for (Index e = 0; e < tables.root_edges; ++e) {
      const Index group = tables.edges[e].target;
      const bool granted = engine.granted(group) && engine.holder(group) == e;
      if (granted && engine.memory().request[e].level != nil && engine.memory().request[e].stamp == now && now != last_)
        since_[e] = now;
      if (!granted) since_.erase(e);
      if (since_.contains(e) && ran_ == GroupId{group}) {
        ++measured;
        longest = std::max(longest, static_cast<std::int64_t>(now - since_[e] + 1));
        since_.erase(e);
      }
    }
    ran_.reset();
    last_ = now;
  }

  const Model& model_;
  std::optional<GroupId> ran_;
  std::map<Index, std::uint64_t> since_;
  std::uint64_t last_ = 0;
};

TEST_CASE("no scenario of the project exceeds the bound on the way to a first run") {
  std::size_t measured = 0;
  for (const char* folder : {"tests/conformance", "behaviours"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(tests::source_dir() / folder)) {
      const std::string path = entry.path().string();
      if (!path.ends_with(".scenario.yaml") || path.find("refused") != std::string::npos) continue;
      CAPTURE(path);
      dsl::DiskFiles files;
      dsl::Sources sources;
      const dsl::ReadScenarioResult read = dsl::read_scenario(path, files, sources);
      const Checked checked = check(read.scenario.behaviour_path, files, sources);
      REQUIRE(checked.lowerable);
      const ResolvedScenario resolved = resolve_scenario(read.scenario, checked.model);
      const Lowered lowered = lower(checked.model);
      const Bounds bounds = find_bounds(checked.model, lowered.view());
      FirstRuns runs(checked.model);
      const Onlooker onlooker = runs.onlooker();
      play(resolved.scenario, checked.model, lowered, {false, &onlooker}, [](const Happening&) {});
      bool several = bounds.handlers_set; // inputs go before runs
      for (const ScenarioStep& step : resolved.scenario.steps) several = several || step.inputs.size() > 1;
      if (several) continue;
      measured += runs.measured;
      CHECK(runs.longest <= bounds.to_first_run);
    }
  }
  CHECK(measured > 100);
}

} // namespace
