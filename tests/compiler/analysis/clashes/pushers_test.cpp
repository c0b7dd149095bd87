// SPDX-License-Identifier: MIT
#include "compiler/analysis/clashes/pushers.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

struct Pushing : tests::Analysed {
  Shared shared{model, graph, facts};
  Conflicts conflicts{model, graph, facts, shared};
  Pushers pushers{conflicts.input()};
  using Analysed::Analysed;

  ConditionId condition(const std::string& text) const {
    for (const ConditionId id : model.conditions.ids()) {
      if (model.conditions[id].text == text) return id;
    }
    FAIL("there is no condition " << text);
    return {};
  }
  bool may_push(const char* causer, const char* text) { return pushers.may_push(provider(causer), condition(text)); }
  std::string preferred(const char* causer, const char* text) {
    const auto out = pushers.preferred(provider(causer), condition(text));
    return out ? model.full_name(*out) : "";
  }
};

const std::string one_pose = "states: {Pose: {values: [moving, standing], initial: moving}}\n";

TEST_CASE("a task that goes before a group may push there, one that goes after it not") {
  const std::string groups =
      "groups:\n  Kick: {when: [Pose == standing]}\n"
      "  Walk: {providers: [{name: walking, sets: [Pose]}, {name: halting, causing: [Pose == standing]}]}\n";
  CHECK(Pushing(one_pose + "roots: {Kick: {priority: 2}, Walk: {priority: 1}}\n" + groups)
            .may_push("Walk.halting", "Pose == standing"));
  CHECK_FALSE(Pushing(one_pose + "roots: {Kick: {priority: 1}, Walk: {priority: 2}}\n" + groups)
                  .may_push("Walk.halting", "Pose == standing"));
}

TEST_CASE("of two causes in one group the earlier is preferred where it can run whenever the later can") {
  Pushing always(one_pose +
                 "roots: {Kick: {priority: 2}, Walk: {priority: 1}}\ngroups:\n  Kick: {when: [Pose == standing]}\n"
                 "  Walk: {providers: [{name: first, when: [Pose == moving], causing: [Pose == standing]},\n"
                 "                     {name: second, causing: [Pose == standing]}]}\n");
  CHECK(always.preferred("Walk.second", "Pose == standing") == "Walk.first");
  CHECK(always.preferred("Walk.first", "Pose == standing") == "");
  CHECK_FALSE(always.may_push("Walk.second", "Pose == standing"));
  Pushing sometimes(
      "states: {Pose: {values: [moving, standing], initial: moving}, Ice: {values: [no, yes], external: true}}\n"
      "roots: {Kick: {priority: 2}, Walk: {priority: 1}}\ngroups:\n  Kick: {when: [Pose == standing]}\n"
      "  Walk: {providers: [{name: first, when: [Ice == no], causing: [Pose == standing]},\n"
      "                     {name: second, causing: [Pose == standing]}]}\nallow: [yaml_word_trap]\nbecause: it is "
      "short\n");
  CHECK(sometimes.preferred("Walk.second", "Pose == standing") == "");
  CHECK(sometimes.may_push("Walk.second", "Pose == standing"));
}

TEST_CASE("what is above another cause, and always free, is preferred to it") {
  Pushing test(one_pose +
               "roots: {Kick: {priority: 2}, Walk: {priority: 1}}\ngroups:\n  Kick: {when: [Pose == standing]}\n"
               "  Walk: {providers: [{name: walking, tasks: [Legs]}, {name: halting, causing: [Pose == standing]}]}\n"
               "  Legs: {causing: [Pose == standing]}\n");
  CHECK(test.may_push("Walk.halting", "Pose == standing"));
  CHECK(test.preferred("Legs", "Pose == standing") == "Walk.halting");
}

TEST_CASE("what is above another cause is not preferred to it for a task below it, whatever the conditions of both") {
  for (const char* const legs : {"", "when: [Pose == moving], "}) {
    Pushing test(one_pose +
                 "roots: {Kick: {priority: 2}, Walk: {priority: 1}}\ngroups:\n  Kick: {when: [Pose == standing]}\n" +
                 "  Walk: {providers: [{name: halting, " + legs +
                 "causing: [Pose == standing], tasks: {Bow: {priority: 1}, Legs: {}}}, {name: walking}]}\n"
                 "  Bow: {when: [Pose == standing]}\n  Legs: {causing: [Pose == standing]}\n");
    CHECK(test.may_push("Legs", "Pose == standing"));
    CHECK(test.preferred("Legs", "Pose == standing") == "");
  }
}

TEST_CASE("what waits for the same itself is pushed for nothing of it") {
  Pushing test(one_pose +
               "roots: {Kick: {priority: 2}, Walk: {priority: 1}}\ngroups:\n  Kick: {when: [Pose == standing]}\n"
               "  Walk: {providers: [{name: resting, when: [Pose == standing], causing: [Pose == standing]}, {name: "
               "walking, sets: [Pose]}]}\n");
  CHECK_FALSE(test.may_push("Walk.resting", "Pose == standing"));
}

TEST_CASE("a push may be a step on the way to another") {
  Pushing test(
      "states: {Door: {values: [shut, open], initial: shut}, Key: {values: [none, mine], initial: none}}\n"
      "roots: {Enter: {priority: 3}, Open: {priority: 2}, Fetch: {priority: 1}}\ngroups:\n  Enter: {when: [Door == "
      "open]}\n"
      "  Open: {providers: [{name: lazy, sets: [Door]}, {name: busy, when: [Key == mine], causing: [Door == open]}]}\n"
      "  Fetch: {providers: [{name: lazy, sets: [Key]}, {name: busy, causing: [Key == mine]}]}\n");
  CHECK(test.may_push("Fetch.busy", "Key == mine"));
}

} // namespace
