// SPDX-License-Identifier: MIT
#include "compiler/transitions/way.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>

namespace director::tests {

namespace {

using namespace compiler::transitions;

/// `Play.running > Walk.slow`, followed by the values from outside.
std::vector<std::string> ways(const std::string& behaviour, const std::string& target) {
  const Compiled compiled = compile("behaviour: test\nlanguage: 1\n" + behaviour);
  std::vector<std::string> out;
  for (const Way& way : find_ways(compiled.model, compiled.group(target))) {
    std::string text;
    for (const Link& link : way.links) text += compiled.model.full_name(link.provider) + " > ";
    text += compiled.model.full_name(way.runs);
    const std::vector<Outside> all =
        outsides_for(compiled.model, find_possible_values(compiled.model), way, Assume::nothing);
    if (all.empty()) text += ": never";
    for (const Outside& outside : all) {
      if (&outside != &all.front()) text += "; or";
      for (const auto& [state, value] : outside.values)
        text += ": " + compiled.model.states[state].name.value + " " + compiled.model.states[state].value_text(value);
    }
    out.push_back(text);
  }
  return out;
}

} // namespace

TEST_CASE("the shortest chain of requesters comes first, of equal ones that which was declared first") {
  CHECK(ways(R"(roots: [Long, Short, Other]
groups:
  Long: {tasks: [Middle]}
  Middle: {tasks: [Walk]}
  Short: {tasks: [Walk]}
  Other: {tasks: [Walk]}
  Walk: {}
)",
             "Walk") == std::vector<std::string>{"Short > Walk", "Long > Middle > Walk", "Other > Walk"});
}

TEST_CASE("what a task with one provider requires is required before others choose") {
  std::string states = "states:\n", pack = "T", groups = "  T: {tasks: [B]}\n  B: {}\n";
  for (int i = 0; i < 12; ++i) {
    const std::string n = std::to_string(i);
    states += "  S" + n + ": {values: [a, b], initial: a, external: true}\n";
    pack += ", A" + n;
    groups += "  A" + n + ": {providers: [{name: u, when: [S" + n + " == a]}, {name: v, when: [S" + n + " == b]}]}\n";
  }
  const std::string behaviour =
      states + "roots: [R]\ngroups:\n  R: {packs: {go: [" + pack + ", Z]}}\n" + groups + "  Z: {when: [S0 == b]}\n";
  CHECK(ways(behaviour, "T") == std::vector<std::string>{"R > T; or: S0 b; or: S0 b: S11 b; or: S0 b: S10 b; or: S0 b: "
                                                         "S10 b: S11 b; or: S0 b: S9 b; or: S0 b: S9 b: S11 b; or: S0 "
                                                         "b: S9 b: S10 b"});
}

TEST_CASE("a preferred provider that does not lead there is kept from running by a value that it refuses") {
  CHECK(ways(R"(states: {Ball: {values: [near, far, lost], initial: near, external: true}}
roots: [Play]
groups:
  Play:
    providers:
      - {name: kicking, when: [Ball == near], tasks: [Kick]}
      - {name: running, tasks: [Walk]}
  Kick: {}
  Walk: {}
)",
             "Walk") == std::vector<std::string>{"Play.running > Walk: Ball far"});
}

TEST_CASE("the value that keeps one preferred provider from running does not let an earlier one run") {
  CHECK(ways(R"(states: {Master: {values: [near, ahead, away], initial: near, external: true}}
roots: [Accompany]
groups:
  Accompany:
    providers:
      - {name: following, when: [Master == ahead]}
      - {name: waiting, when: [Master == near]}
      - {name: alone, tasks: [Walk]}
  Walk: {}
)",
             "Walk") == std::vector<std::string>{"Accompany.alone > Walk: Master away"});
}

TEST_CASE("conditions on the way that exclude each other leave no values") {
  CHECK(ways(R"(states: {Ball: {values: [near, far], initial: near, external: true}}
roots: [Play]
groups:
  Play: {when: [Ball == near], tasks: [Walk]}
  Walk: {when: [Ball == far]}
)",
             "Walk") == std::vector<std::string>{"Play > Walk: never"});
}

TEST_CASE("of a group that is needed, a provider is chosen whose condition agrees with the others") {
  CHECK(ways(R"(states: {Ground: {values: [flat, rough], initial: flat, external: true}}
roots: [Climb]
groups:
  Climb: {when: [Ground == rough], needs: [Move]}
  Move: {providers: [{name: rolling, when: [Ground == flat]}, {name: stepping, when: [Ground == rough]}]}
)",
             "Climb") == std::vector<std::string>{"Climb: Ground rough"});
}

TEST_CASE("if the values differ with the provider of a needed group, those of the first one come first") {
  CHECK(ways(R"(states: {Tool: {values: [none, hand, fork], initial: none, external: true}}
roots: [Carry]
groups:
  Carry: {needs: [Lift]}
  Lift: {providers: [{name: lifting, when: [Tool == hand]}, {name: forking, when: [Tool == fork]}]}
)",
             "Carry") == std::vector<std::string>{"Carry: Tool hand; or: Tool fork"});
}

TEST_CASE("what the other tasks of a unit want comes second, as a push may cause it") {
  const auto of_pack = [](const std::string& manner) {
    return ways(R"(states: {Door: {values: [closed, open], initial: closed, external: true}}
roots: [Deliver]
groups:
  Deliver: {packs: {go: {Drive: {}, Enter: {)" +
                    manner + R"(}}}}
  Drive: {}
  Enter: {when: [Door == open]}
)",
                "Drive");
  };
  CHECK(of_pack("") == std::vector<std::string>{"Deliver > Drive; or: Door open"});
  CHECK(of_pack("optional: true") == std::vector<std::string>{"Deliver > Drive"});
  CHECK(of_pack("apart: true") == std::vector<std::string>{"Deliver > Drive"});
}

TEST_CASE("a preferred provider that no value prevents may still lack what it needs, so its values are tried last") {
  CHECK(ways(R"(states: {Ball: {values: [near, far], initial: near, external: true}}
roots: [Play]
groups:
  Play:
    providers:
      - {name: throwing, needs: [Arm]}
      - {name: kicking, when: [Ball == far], tasks: [Kick]}
  Kick: {}
  Arm: {providers: [{name: broken, when: [Ball == near]}]}
)",
             "Kick") == std::vector<std::string>{"Play.kicking > Kick: Ball far"});
}

TEST_CASE("a request that leads back to the target makes no way") {
  CHECK(ways(R"(roots: [Play]
groups:
  Play: {tasks: [Seek]}
  Seek: {tasks: [Turn]}
  Turn: {tasks: {Seek: {optional: true}}}
)",
             "Seek") == std::vector<std::string>{"Play > Seek"});
}

TEST_CASE("no chain leads to what nothing requests") {
  CHECK(ways("roots: [Walk]\ngroups: {Walk: {needs: [Legs]}, Legs: {}}\n", "Legs").empty());
}

TEST_CASE("groups with ways are found without them") {
  const Compiled compiled = compile(R"(behaviour: test
language: 1
roots: [Play]
groups:
  Play: {tasks: [Kick], needs: [Eyes]}
  Kick: {needs: [Legs]}
  Rest: {tasks: [Kick]}
  Eyes: {}
  Legs: {tasks: [Motor]}
  Motor: {}
)");
  const compiler::IdSet<compiler::GroupId> led_to = find_led_to(compiled.model);
  for (const compiler::GroupId id : compiled.model.groups.ids()) {
    INFO(compiled.model.groups[id].name.value);
    CHECK(led_to.contains(id) == !find_ways(compiled.model, id).empty());
  }
}

} // namespace director::tests
