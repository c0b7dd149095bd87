// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/waiting.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

struct Waits : tests::Analysed {
  using Analysed::Analysed;
  bool task(const std::string& name) const { return Waiting(model, facts).may_wait(group(name)); }
  bool first(const std::string& name) const { return Waiting(model, facts).may_be_first(provider(name)); }
};

const std::string two_values = "states: {Pose: {values: [moving, standing], initial: moving, external: true}}\n";

TEST_CASE("a task waits for a condition, and not where another provider of its group does without") {
  const Waits waits(two_values + "roots: [Kick, Pass]\ngroups:\n  Kick: {when: [Pose == standing]}\n"
                                 "  Pass: {providers: [{name: hard, when: [Pose == standing]}, {name: softly}]}\n");
  CHECK(waits.task("Kick"));
  CHECK_FALSE(waits.task("Pass"));
}

TEST_CASE("providers that cover all values together leave nothing to wait for") {
  const Waits waits(two_values +
                    "roots: [Kick]\ngroups:\n"
                    "  Kick: {providers: [{name: a, when: [Pose == standing]}, {name: b, when: [Pose == moving]}]}\n");
  CHECK_FALSE(waits.task("Kick"));
}

TEST_CASE("a member of a unit waits with the others") {
  const Waits waits(two_values +
                    "roots: [Play]\ngroups:\n  Play: {packs: {go: {Kick: {}, Look: {}, Sing: {apart: true}}}}\n"
                    "  Kick: {when: [Pose == standing]}\n  Look: {}\n  Sing: {}\n");
  CHECK(waits.task("Look"));
  CHECK_FALSE(waits.task("Sing"));
  CHECK_FALSE(waits.task("Play"));
}

TEST_CASE("what always holds where a task is requested is not waited for") {
  const Waits waits(two_values + "roots: [Play]\ngroups:\n  Play: {when: [Pose == standing], tasks: [Kick]}\n"
                                 "  Kick: {when: [Pose == standing]}\n");
  CHECK(waits.task("Play"));
  CHECK_FALSE(waits.task("Kick"));
}

TEST_CASE("a provider behind one that needs no more is never what a task waits for") {
  const Waits waits(two_values + "roots: [Kick]\ngroups:\n  Kick:\n    providers:\n"
                                 "      - {name: aiming, when: [Pose == standing], needs: [Ball]}\n"
                                 "      - {name: blind, when: [Pose == standing]}\n"
                                 "      - {name: late, when: [Pose == moving], needs: [Ball]}\n"
                                 "  Ball: {}\n");
  CHECK(waits.first("Kick.aiming"));
  CHECK(waits.first("Kick.blind"));
  CHECK_FALSE(waits.first("Kick.late"));
}

TEST_CASE("a choice of other needs serves as well, if its groups are available with those of the first") {
  const std::string start = two_values + "roots: [Kick]\ngroups:\n  Kick: {needs: [Foot]}\n";
  CHECK_FALSE(
      Waits(start + "  Foot: {providers: [{name: left, when: [Pose == standing]}, {name: right}]}\n").task("Kick"));
  CHECK(Waits(start +
              "  Foot: {providers: [{name: left, when: [Pose == standing]}, {name: right, needs: [Hip]}]}\n  Hip: {}\n")
            .task("Kick"));
}

TEST_CASE("needs that are shared by many choices, forty levels deep, are looked at once") {
  std::string behaviour = two_values + "roots: [Kick]\ngroups:\n  Kick: {needs: [L0]}\n";
  for (int level = 0; level < 40; ++level) {
    const std::string need = level < 39 ? ", needs: [L" + std::to_string(level + 1) + "]" : "";
    behaviour += "  L" + std::to_string(level) + ": {providers: [{name: hard, when: [Pose == standing]" + need +
                 "}, {name: softly" + need + "}]}\n";
  }
  CHECK_FALSE(Waits(behaviour).task("Kick"));
}

} // namespace
