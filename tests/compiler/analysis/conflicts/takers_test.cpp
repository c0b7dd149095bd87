// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/conflicts/packmates.hpp"
#include "compiler/analysis/conflicts/spoilers.hpp"
#include "compiler/analysis/conflicts/takers.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

struct Taking : tests::Analysed {
  Shared shared{model, graph, facts};
  Conflicts conflicts{model, graph, facts, shared};
  Takers takers{conflicts.input()};
  Packmates packmates{conflicts.input(), takers};
  using Analysed::Analysed;

  std::string names(const Groups& groups) const {
    std::string out;
    for (const GroupId id : groups) out += model.groups[id].name.value + " ";
    return out;
  }
  const Pack& pack(const char* by) const { return model.providers[provider(by)].packs.front(); }
  const Task& entry(const char* by, const char* target) const {
    for (const Task& task : pack(by).tasks) {
      if (task.target == group(target)) return task;
    }
    FAIL("no entry for " << target);
    return pack(by).tasks.front();
  }

  /// "what for by, kind steady from; " for each that finds something taken.
  std::string mates(const char* by) {
    std::string out;
    for (const PackEntry& entry : packmates.of(model.providers[provider(by)], pack(by))) {
      for (const Packmate& mate : entry.mates) {
        out += model.groups[mate.taker.group].name.value + " from " + model.groups[entry.task->target].name.value +
               " by " + model.groups[mate.taker.by->target].name.value;
        out += mate.taker.kind == Taker::Kind::before ? " before" : " in one unit";
        out += mate.taker.steady ? " steady" : "";
        out += mate.from_entry ? " entry" : "";
        out += mate.from_below ? " below" : "";
        out += "; ";
      }
    }
    return out;
  }
  std::string spoilers(const char* by, const char* first, const char* over, bool is_before_below = false) {
    const Unit unit{&entry(by, first)};
    const Beside beside{group(by), &unit, unit.front(), &entry(by, over), is_before_below};
    return names(Spoilers(conflicts.input(), takers, beside).of(shared.units().needed(group(first))));
  }
};

TEST_CASE("what a task must take is what all its providers do") {
  Taking test(
      "roots: [Plan]\ngroups:\n  Plan: {tasks: [Walk]}\n"
      "  Walk: {providers: [{name: fast, needs: [Legs, Arms]}, {name: slow, when: [Sun == up], needs: [Legs]}]}\n"
      "  Legs: {needs: [Servos]}\n  Arms: {}\n  Servos: {}\n"
      "states: {Sun: {values: [up, down], external: true}}\n");
  CHECK(test.names(test.takers.must(test.provider("Walk.fast"))) == "Walk Legs Arms Servos ");
  CHECK(test.names(test.takers.must(test.provider("Walk.slow"))) == "Walk Legs Servos ");
}

TEST_CASE("one rank is compared at all levels, and equals by the packs that request them") {
  Taking test(
      "roots: [Plan]\ngroups:\n"
      "  Plan: {packs: {go: {High: {priority: 5}, Low: {}, Beside: {}}}}\n  High: {}\n  Low: {}\n  Beside: {}\n");
  const auto entry = [&](const char* name) -> const Task& { return test.entry("Plan", name); };
  const GroupId plan = test.group("Plan");
  CHECK(test.takers.always_before(entry("High"), entry("Low")));
  CHECK_FALSE(test.takers.always_before(entry("Low"), entry("High")));
  CHECK(test.takers.always_first_of_equals(plan, entry("Low"), entry("Beside")));
  CHECK_FALSE(test.takers.always_first_of_equals(plan, entry("Beside"), entry("Low")));
  CHECK(test.takers.always_beside(plan, entry("Beside"), entry("Low")));
  CHECK_FALSE(test.takers.always_beside(plan, entry("High"), entry("Low")));
}

TEST_CASE("an entry that goes before takes what another one, and what is below that, wants") {
  CHECK(
      Taking("roots: [Plan]\ngroups:\n  Plan: {packs: {go: {Legs: {priority: 5, apart: true}, Walk: {apart: true}}}}\n"
             "  Walk: {tasks: [Legs]}\n  Legs: {}\n")
          .mates("Plan") == "Legs from Walk by Legs before steady entry below; ");
}

TEST_CASE("of two equals each is granted before anything below the other is tried") {
  CHECK(Taking("roots: [Plan]\ngroups:\n  Plan: {packs: {go: {Walk: {apart: true}, Legs: {}}}}\n  Walk: {tasks: "
               "[Legs]}\n  Legs: {}\n")
            .mates("Plan") == "Legs from Walk by Legs before steady below; ");
  // Without the needs of the earlier one.
  CHECK(Taking("roots: [Plan]\ngroups:\n  Plan: {packs: {go: {Walk: {apart: true}, Legs: {}}}}\n"
               "  Walk: {needs: [Legs], tasks: [Legs]}\n  Legs: {}\n")
            .mates("Plan")
            .find("by Legs before steady") == std::string::npos);
}

TEST_CASE("members of one unit are granted before anything below them") {
  CHECK(
      Taking(
          "roots: [Plan]\ngroups:\n  Plan: {packs: {go: {Walk: {}, Legs: {}}}}\n  Walk: {tasks: [Legs]}\n  Legs: {}\n")
          .mates("Plan") == "Legs from Walk by Legs in one unit steady below; ");
}

TEST_CASE("what another task may hold spoils it") {
  const std::string plan = "  Plan: {packs: {go: {Legs: {priority: 5, apart: true}, Walk: {apart: true}}}}\n"
                           "  Walk: {tasks: [Legs]}\n  Legs: {}\n";
  CHECK(Taking("roots: [Plan]\ngroups:\n" + plan).spoilers("Plan", "Legs", "Walk") == "");
  CHECK(Taking("roots: [Plan, Dance]\ngroups:\n" + plan + "  Dance: {tasks: [Legs]}\n")
            .spoilers("Plan", "Legs", "Walk") == "Legs ");
}

TEST_CASE("what is below an equal spoils it, unless that is tried later") {
  Taking test("roots: [Plan]\ngroups:\n  Plan: {packs: {go: {Walk: {apart: true}, Legs: {}}}}\n  Walk: {tasks: "
              "[Legs]}\n  Legs: {}\n");
  CHECK(test.spoilers("Plan", "Legs", "Walk") == "Legs ");
  CHECK(test.spoilers("Plan", "Legs", "Walk", true) == "");
}

} // namespace
