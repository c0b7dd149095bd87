// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/contexts.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

struct InContext : tests::Analysed {
  using Analysed::Analysed;
  std::string active() const { return names(facts.active); }
  std::string capable() const { return names(facts.capable); }
  std::string excluded() const { return names(facts.excluded); }
};

const std::string any_door = "states: {Door: {values: [shut, ajar, open], initial: shut, external: true}}\n";

TEST_CASE("conditions of a task and of its need that exclude each other leave nothing to run") {
  const InContext found(any_door +
                        "roots: [Enter]\ngroups:\n  Enter: {when: [Door == open], needs: [Lock], tasks: [Look]}\n"
                        "  Lock: {when: [Door == shut]}\n  Look: {}\n");
  CHECK(found.capable() == "Lock Look ");
  CHECK(found.active().empty());
  CHECK(found.excluded().empty());
}

TEST_CASE("one plan of several with possible conditions is enough") {
  const InContext found(any_door +
                        "roots: [Enter]\ngroups:\n  Enter: {when: [Door == open], needs: [Hold]}\n"
                        "  Hold: {providers: [{name: firmly, needs: [Lock]}, {name: gently, when: [Door >= ajar]}]}\n"
                        "  Lock: {when: [Door == shut]}\n");
  CHECK(found.active() == "Enter ");
}

TEST_CASE("what is requested under some values alone never begins under others") {
  const InContext found(any_door + "roots: [Enter]\ngroups:\n  Enter: {when: [Door == open], tasks: [Step]}\n"
                                   "  Step: {tasks: [Legs]}\n"
                                   "  Legs: {providers: [{name: back, when: [Door == shut]}, {name: forth}]}\n");
  CHECK(found.active() == "Enter Step Legs.forth ");
  CHECK(found.excluded() == "Legs.back ");
}

TEST_CASE("a request remains while another provider of its group runs, and while `stay` holds") {
  const std::string step = "  Step: {providers: [{name: back, when: [Door == shut]}, {name: forth}]}\n";
  const InContext other(any_door +
                        "roots: [Enter]\ngroups:\n  Enter:\n    providers:\n"
                        "      - {name: going, when: [Door == open], tasks: [Step]}\n      - {name: waiting}\n" +
                        step);
  CHECK(other.excluded().empty());
  const InContext staying(any_door +
                          "roots: [Enter]\ngroups:\n"
                          "  Enter: {when: [Door == open], stay: [Door >= shut], tasks: [Step]}\n" +
                          step);
  CHECK(staying.excluded().empty());
}

TEST_CASE("what is granted only together with another task never begins where that one cannot run") {
  const std::string rest = "  Kick: {when: [Door == open]}\n"
                           "  Head: {providers: [{name: follow, when: [Door == open]}, {name: search}]}\n";
  const InContext whole(any_door + "roots: [Play]\ngroups:\n  Play: {packs: {play: {Head: {}, Kick: {}}}}\n" + rest);
  CHECK(whole.active() == "Play Kick Head.follow ");
  const InContext apart(any_door +
                        "roots: [Play]\ngroups:\n  Play: {packs: {play: {Head: {}, Kick: {apart: true}}}}\n" + rest);
  CHECK(apart.active() == "Play Kick Head.follow Head.search ");
  const InContext flat(any_door + "roots: [Play]\ngroups:\n  Play: {tasks: {Head: {}, Kick: {}}}\n" + rest);
  CHECK(flat.active() == "Play Kick Head.follow Head.search ");
}

TEST_CASE(
    "a request that another provider keeps stands without what it was granted with, though it requests the same") {
  const InContext found(any_door + "roots: [Play]\ngroups:\n  Play:\n    providers:\n"
                                   "      - {name: idle, needs: [Lock], tasks: [Kick]}\n"
                                   "      - {name: playing, packs: {play: {Lock: {}, Kick: {}}}}\n"
                                   "  Kick: {when: [Door == open]}\n  Lock: {when: [Door == shut]}\n");
  CHECK(found.active() == "Play.idle Play.playing Kick Lock ");
}

TEST_CASE("a value of the start alone is over where something was requested under another one") {
  const std::string head = "roots: [Play, Camera]\ngroups:\n  Play:\n    providers:\n"
                           "      - {name: chase, when: [Ball == seen], tasks: [Head]}\n      - {name: idle}\n"
                           "  Head: {providers: [{name: follow, when: [Ball >= seen]}, {name: wander}]}\n";
  const std::string ball = "states: {Ball: {values: [unknown, seen, lost]";
  CHECK(InContext(ball + "}}\n" + head + "  Camera: {sets: [Ball >= seen]}\n").active() ==
        "Play.chase Play.idle Head.follow Camera ");
  CHECK(InContext(ball + ", initial: unknown}}\n" + head + "  Camera: {sets: [Ball >= seen]}\n").active() ==
        "Play.chase Play.idle Head.follow Camera ");
  CHECK(InContext(ball + ", initial: unknown}}\n" + head + "  Camera: {sets: [Ball]}\n").active() ==
        "Play.chase Play.idle Head.follow Head.wander Camera ");
}

TEST_CASE("a provider that is held by a push requests also where its own promise has come true") {
  const InContext found(
      "states: {Door: {values: [shut, open], initial: shut}}\n"
      "roots: {Enter: {priority: 2}, Push: {priority: 1}}\ngroups:\n  Enter: {when: [Door == open]}\n"
      "  Push: {providers: [{name: resting}, {name: pushing, when: [Door == shut], causing: [Door == open], "
      "tasks: [Lean]}]}\n"
      "  Lean: {providers: [{name: on_air, when: [Door == open]}, {name: on_wood}]}\n");
  CHECK(found.excluded().empty());
  CHECK(found.active() == "Enter Push.resting Push.pushing Lean.on_air Lean.on_wood ");
}

TEST_CASE("where its group is requested an earlier one always comes first") {
  const InContext found(any_door + "roots: [Enter]\ngroups:\n  Enter: {when: [Door == open], tasks: [Step]}\n"
                                   "  Step: {providers: [{name: forth, when: [Door >= ajar]}, {name: back}]}\n");
  CHECK(found.active() == "Enter Step.forth ");
  CHECK(found.excluded().empty());
}

} // namespace
