// SPDX-License-Identifier: MIT
// Which changes say that C++ written for the old behaviour does not compile with the new one.
#include "tests/compiler/diff/told.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;

/// A group with this text, and what it may request and set.
std::string walk(const std::string& text, const std::string& rest = {}) {
  return "states: {Pose: {values: [moving, slow, still], initial: still}}\ntriggers: [Tick]\nroots: [Walk]\ngroups: "
         "{Walk: {" +
         text + "}, Legs: {}, Head: {}" + rest + "}\n";
}

/// The messages of the changes that break C++, a line each.
std::string broken(const std::string& before, const std::string& after) {
  std::string out;
  for (const compiler::BehaviourChange& change : tests::changes({before, {}}, {after, {}})) {
    if (change.breaks_code) out += change.message + "\n";
  }
  return out;
}

} // namespace

TEST_CASE("a task that a pack must be given breaks the code that gives it what it had") {
  const auto robot = [](const std::string& tasks) { return walk("packs: {go: {" + tasks + "}}"); };
  CHECK(broken(robot("Legs: {}"), robot("Legs: {}, Head: {}")) == "`Walk`, pack `go`, may now request `Head`\n");
  CHECK(broken(robot("Legs: {}"), robot("Legs: {}, Head: {optional: true}")).empty());
  CHECK(broken(robot("Head: {optional: true}"), robot("Head: {}")) ==
        "`Walk`, pack `go`, requests `Head` as mandatory, before as optional\n");
  CHECK(broken(robot("Head: {}"), robot("Head: {optional: true}")).empty());
  CHECK(broken(walk("tasks: [Legs]"), walk("tasks: [Legs, Head]")).empty());
}

TEST_CASE("what a body may no longer set, promise or ask breaks the code that does it") {
  CHECK(broken(walk("triggers: [Tick]"), walk("")) == "`Tick` no longer calls `Walk` again\n");
  CHECK(broken(walk("causing: [Pose == slow|still]"), walk("causing: [Pose == still]")) ==
        "`Walk` no longer promises `Pose == slow|still`\n");
  CHECK(broken(walk("causing: [Pose == still]"), walk("causing: [Pose == slow|still]")).empty());
  CHECK(broken(walk("causing: [Pose == still]"), walk("sets: [Pose == still]")).empty());
  CHECK(broken(walk("sets: [Pose == slow|still]"), walk("sets: [Pose == slow], causing: [Pose == still]")).empty());
  CHECK(broken(walk("sets: [Pose == slow|still]"), walk("sets: [Pose == slow]")) ==
        "`Walk` may no longer set `Pose == still`\n");
}

TEST_CASE("what a handler may no longer set breaks the code that sets it") {
  CHECK(broken(walk("start: {sets: [Pose == slow|still]}"), walk("start: {sets: [Pose == slow]}")) ==
        "the start handler of `Walk` may set `Pose == slow`, before `Pose == slow|still`\n");
  CHECK(broken(walk("start: {sets: [Pose == slow]}"), walk("start: {sets: [Pose == slow|still]}")).empty());
  const auto two = [](const std::string& sets) {
    return "states: {Pose: {values: [slow, still], initial: still}, Eye: {values: [shut, open], initial: shut}}\n"
           "roots: [Walk]\ngroups: {Walk: {stop: {sets: [" +
           sets + "]}}}\n";
  };
  CHECK(broken(two("Pose == slow, Eye == open"), two("Eye == open")) ==
        "the stop handler of `Walk` may set `Eye == open`, before `Eye == open` and `Pose == slow`\n");
}

TEST_CASE("the first use of time breaks the code that steps without it") {
  const std::string now = "something in it uses time now, so each `step` is given the time\n";
  CHECK(broken(walk(""), walk("every: 1 s")) == now);
  CHECK(broken(walk("causing: [Pose == still]"), walk("causing: [Pose == still within 1 s]")) == now);
  CHECK(broken(walk("every: 1 s"), walk("")).empty());
  CHECK(broken(walk("every: 1 s"), walk("every: 2 s")).empty());
}
