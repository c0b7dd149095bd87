// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

struct InConflict : tests::Analysed {
  using Analysed::Analysed;
  Shared shared{model, graph, facts};
  Conflicts conflicts{model, graph, facts, shared};

  /// `Step>Legs `, for tasks that are never granted.
  std::string refused() const {
    std::string out;
    for (const auto& [edge, places] : conflicts.grants().refused()) out += model.edge_name(edge) + " ";
    return out;
  }
  std::string idle() const {
    std::string out;
    for (const auto& [id, lacking] : conflicts.grants().idle()) out += model.full_name(id) + " ";
    return out;
  }
  /// `Plan: Step>Legs `: the owner of the pack, and the loser below it.
  std::string losers() const {
    std::string out;
    for (const Loser& loser : conflicts.losers())
      out += model.full_name(loser.above) + ": " + model.edge_name(loser.refused.task->edge) + " ";
    return out;
  }
  std::string starving() const {
    std::string out;
    for (const StarvingTask& each : conflicts.starving_tasks())
      out += model.edge_name(each.places.front().task->edge) + (each.optional ? "? " : " ");
    return out;
  }
};

TEST_CASE("what a group needs is never granted to those below it") {
  const InConflict found("roots: [Plan]\ngroups:\n  Plan: {needs: [Legs], packs: {go: {Step: {}}}}\n"
                         "  Step: {packs: {go: {Legs: {}}}}\n  Legs: {}\n");
  CHECK(found.refused() == "Step>Legs ");
  CHECK(found.losers() == "Plan: Step>Legs ");
  CHECK(found.starving().empty());
  CHECK(found.conflicts.grants().is_tried(found.group("Step")));
  CHECK_FALSE(found.conflicts.grants().is_tried(found.group("Legs")));
}

TEST_CASE("a provider that needs what is held above it is idle where another one of its group can do without") {
  const InConflict found("roots: [Plan]\ngroups:\n  Plan: {needs: [Legs], packs: {go: {Step: {}}}}\n"
                         "  Step: {providers: [{name: firm, needs: [Legs]}, {name: light}]}\n  Legs: {}\n");
  CHECK(found.idle() == "Step.firm ");
  CHECK(found.refused().empty());
}

TEST_CASE("an optional task starves beside a mandatory one that takes what it must have") {
  const InConflict found("roots: [Play]\ngroups:\n  Play: {packs: {go: {Walk: {}, Look: {optional: true}}}}\n"
                         "  Walk: {needs: [Legs]}\n  Look: {needs: [Legs]}\n  Legs: {}\n");
  CHECK(found.starving() == "Play>Look? ");
  CHECK(found.losers().empty());
}

TEST_CASE("no task starves beside one that may have to wait, or that takes something else") {
  const std::string play = "roots: [Play]\ngroups:\n  Play: {packs: {go: {Walk: {}, Look: {optional: true}}}}\n"
                           "  Look: {needs: [Legs]}\n  Legs: {}\n";
  const InConflict waiting("states: {Door: {values: [shut, open], initial: shut, external: true}}\n" + play +
                           "  Walk: {when: [Door == open], needs: [Legs]}\n");
  CHECK(waiting.starving().empty());
  const InConflict apart(play + "  Walk: {needs: [Wheels]}\n  Wheels: {}\n");
  CHECK(apart.starving().empty());
  CHECK(apart.refused().empty());
}

} // namespace
