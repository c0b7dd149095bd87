// SPDX-License-Identifier: MIT
// Tests compiler/trace/waits.cpp. The answers are those of `directorc why`, as both call the same function; here it is
// tested when they change.
#include "compiler/lower/lower.hpp"
#include "compiler/lower/row_names.hpp"
#include "compiler/trace/waits.hpp"
#include "tests/compiler/cli/world.hpp"
#include "tests/compiler/support/rover_with_key.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director::compiler;
using director::tests::rover_with_key;
using director::tests::World;

const std::string kicker_yaml = R"(behaviour: kicker
language: 1
states:
  Pose: {values: [moving, still], initial: moving}
roots:
  Walk: {priority: 10}
  Kick: {priority: 20}
groups:
  Kick: {when: [Pose == still], needs: [Legs], tasks: [Legs]}
  Walk:
    providers:
      - {name: walking, sets: [Pose == moving], needs: [Legs], tasks: [Legs]}
      - {name: halting, causing: [Pose == still], needs: [Legs], tasks: [Legs]}
  Legs: {}
)";

struct Told {
  std::string text; ///< of the event in its line
  std::string group, answer;
  bool operator==(const Told&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Told& told) {
  return out << "[" << told.text << "] " << told.group << ": " << told.answer;
}

} // namespace

TEST_CASE(
    "the answers of a recording change where what keeps a group does, and end where it runs or nothing is known") {
  World world;
  world.files.add("kicker.yaml", kicker_yaml);
  world.files.add("s.yaml", R"(scenario: a kick
behaviour: kicker.yaml
script:
  Walk.halting:
    - {reason: wait, set: {Pose: still}, continue: true}
    - {wait: 1 s, tasks: [Legs]}
  Kick.default: {tasks: [Legs]}
steps:
  - request: Walk
  - request: Kick
  - advance: 1 s
)");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  const std::string trace = world.outputs.files.at("run.jsonl");
  director::dsl::Sources sources;
  const Checked checked = check("kicker.yaml", world.files, sources);
  REQUIRE(checked.lowerable);
  const Lowered lowered = lower(checked.model);

  const auto told = [&](const std::string& text) {
    TraceLines lines(text);
    lines.next();
    const Waits waits = find_waits(lines, checked.model, lowered, sources);
    std::vector<Told> out;
    for (const Waits::Change& change : waits.changes) {
      std::size_t at = 0;
      for (std::size_t line = 1; line < change.line; ++line) at = text.find('\n', at) + 1;
      const Json event = parse_json(text.substr(at, text.find('\n', at) - at)).value();
      out.push_back({event["event"].as_text() + " " + event["edge"].as_text(),
                     checked.model.groups[GroupId{change.group}].name.value,
                     change.text == 0 ? "" : waits.texts.at(change.text - 1)});
    }
    return std::pair{out, waits};
  };

  const auto [whole, waits] = told(trace);
  CHECK(whole ==
        std::vector<Told>{
            {"push root>Kick", "Kick",
             "Kick waits (root>Kick): until Pose == still, which Walk.halting could cause\n"
             "  Pose is moving (kicker.yaml:9)\n"
             "  Walk.halting is to cause it: pushed for root>Kick (kicker.yaml:13)\n"},
            {"queue root>Walk", "Kick", ""},
            {"queue root>Walk", "Walk",
             "Walk waits (root>Walk): Legs, which it needs, is held by Kick>Legs, and root>Kick (priority 20) goes "
             "before root>Walk (priority 10)\n  it is held for Kick, priority 0, that for the program, priority 20 "
             "(kicker.yaml:9)\n"}});
  const RowNames rows(checked.model, lowered);
  const director::Names names = rows.names();
  REQUIRE(waits.blockers.size() == 2);
  CHECK(waits.blockers[0] == Waits::Blocker{});
  CHECK(std::string(names.group(names.self, waits.blockers[1].group)) == "Legs");
  CHECK(std::string(names.edge(names.self, waits.blockers[1].edge)) == "Kick>Legs");
  CHECK_FALSE(waits.replayed.difference);
  CHECK(waits.held.empty());
  CHECK(waits.last_line == static_cast<std::size_t>(std::count(trace.begin(), trace.end(), '\n')));

  const std::size_t push = trace.find("{\"t\":0,\"n\":", trace.find("\"edge\":\"root>Kick\""));
  const auto [some, cut] = told(trace.substr(0, push) + "{\"event\":\"dropped\",\"count\":2}\n" + trace.substr(push));
  CHECK(some.empty());
  CHECK(cut.replayed.dropped == 2);
}

TEST_CASE("a group whose request is queued while its requester is about to run stays, and with it what it requests") {
  World world;
  world.files.add("carrier.yaml", R"(behaviour: carrier
language: 1
states: {Charge: {values: [low, high], initial: high, external: true}}
roots: [Carry]
groups:
  Carry: {needs: [Walk], tasks: [Walk]}
  Walk: {providers: [{name: fast, when: [Charge == high], tasks: [Rest]}, {name: slow, tasks: [Rest]}]}
  Rest: {when: [Charge == low]}
)");
  world.files.add("s.yaml", R"(scenario: the charge is low when there is a new task
behaviour: carrier.yaml
steps:
  - request: Carry
  - inputs: [{request: Carry}, {set: {Charge: low}}]
)");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  director::dsl::Sources sources;
  const Checked checked = check("carrier.yaml", world.files, sources);
  REQUIRE(checked.lowerable);
  const std::string& trace = world.outputs.files.at("run.jsonl");
  TraceLines lines(trace);
  lines.next();
  const Waits waits = find_waits(lines, checked.model, lower(checked.model), sources);
  const std::size_t queued = trace.find(R"("event":"queue","edge":"Carry>Walk","why":"waiting")");
  REQUIRE(queued != std::string::npos);
  const auto line = static_cast<std::size_t>(
      1 + std::count(trace.begin(), trace.begin() + static_cast<std::ptrdiff_t>(queued), '\n'));
  CHECK(waits.stays == std::vector<Waits::Stays>{{line, 1}});
  CHECK(waits.held.empty());
}

TEST_CASE(
    "a group that is kept for another requester, as it lost its condition, does not stay for the one that it had") {
  World world;
  world.files.add("guide.yaml", R"(behaviour: guide
language: 1
states:
  Map: {values: [missing, loaded], initial: missing}
  Day: {values: [work, rest], initial: work, external: true}
roots: [Lead, Walk]
groups:
  Lead: {providers: [{name: guiding, when: [Map == loaded], tasks: [Walk]}, {name: resting, when: [Day == rest]}]}
  Walk: {when: [Day == work]}
)");
  world.files.add("s.yaml", R"(scenario: the day ends during a walk
behaviour: guide.yaml
steps:
  - request: Lead
  - request: Walk
  - set: {Day: rest}
)");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  director::dsl::Sources sources;
  const Checked checked = check("guide.yaml", world.files, sources);
  REQUIRE(checked.lowerable);
  const std::string& trace = world.outputs.files.at("run.jsonl");
  REQUIRE(trace.find(R"("event":"grant","group":"Walk","edge":"limbo","from":"root>Walk")") != std::string::npos);
  TraceLines lines(trace);
  lines.next();
  CHECK(find_waits(lines, checked.model, lower(checked.model), sources).stays.empty());
}

TEST_CASE("an answer changes where a group that could cause the condition stops without an event") {
  World world;
  world.files.add("s.yaml", R"(behaviour: s
language: 1
states: {Pose: {values: [moving, standing], initial: moving}}
roots: {Keeper: {priority: 10}, Chief: {priority: 50}, Photo: {priority: 5}}
groups:
  Keeper: {needs: [Base], tasks: [Base]}
  Chief: {needs: [Base], packs: {idle: [], work: [Base]}}
  Photo: {when: [Pose == standing]}
  Base: {causing: [Pose == standing]}
)");
  world.files.add("s.scenario.yaml", R"(scenario: the chief takes the base, and does not request it
behaviour: s.yaml
script:
  Chief: [{pack: idle}]
steps:
  - request: [Photo, Keeper]
  - advance: 1 s
  - request: Chief
)");
  REQUIRE(world.directorc({"simulate", "s.scenario.yaml", "--trace", "run.jsonl"}) == 0);
  director::dsl::Sources sources;
  const Checked checked = check("s.yaml", world.files, sources);
  REQUIRE(checked.lowerable);
  TraceLines lines(world.outputs.files.at("run.jsonl"));
  lines.next();
  const Waits waits = find_waits(lines, checked.model, lower(checked.model), sources);
  std::string last;
  for (const Waits::Change& change : waits.changes) {
    if (checked.model.groups[GroupId{change.group}].name.value == "Photo") last = waits.texts.at(change.text - 1);
  }
  CHECK(waits.held.size() == 1);
  CHECK(last.find("Base could cause it, but nothing requests Base") != std::string::npos);
}

TEST_CASE(
    "a group that runs in the provider of its push is noted where it is not because of it, and where it is again") {
  World world;
  world.files.add("rover.yaml", rover_with_key);
  world.files.add("s.yaml", R"(scenario: High goes before the push for Photo, and brakes for want of the key
behaviour: rover.yaml
script: {Drive: {continue: true}}
steps:
  - request: [Low, Photo]
  - request: High
  - set: {Key: off}
  - cancel: High
)");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  director::dsl::Sources sources;
  const Checked checked = check("rover.yaml", world.files, sources);
  REQUIRE(checked.lowerable);
  const std::string& trace = world.outputs.files.at("run.jsonl");
  TraceLines lines(trace);
  lines.next();
  const Waits waits = find_waits(lines, checked.model, lower(checked.model), sources);
  const auto line_of = [&](const std::string& event) {
    const std::size_t at = trace.find(event);
    REQUIRE(at != std::string::npos);
    return static_cast<std::size_t>(1 +
                                    std::count(trace.begin(), trace.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  };
  REQUIRE(waits.without_effect.size() == 1);
  CHECK(waits.without_effect[0].line >= line_of(R"("input":"set")"));
  CHECK(waits.without_effect[0].line < line_of(R"("input":"cancel")"));
  REQUIRE(waits.in_force.size() == 1);
  CHECK(waits.in_force[0].line >= line_of(R"("input":"cancel")"));
  CHECK(checked.model.groups[GroupId{waits.in_force[0].group}].name.value == "Drive");
}

TEST_CASE("a push that is released while it has no effect says nothing about the next one") {
  World world;
  world.files.add("rover.yaml", rover_with_key);
  world.files.add("s.yaml", R"(scenario: the push for Photo is released while High brakes for want of the key
behaviour: rover.yaml
script: {Drive: {continue: true}}
steps:
  - request: [Low, Photo]
  - request: High
  - set: {Key: off}
  - cancel: Photo
  - cancel: High
  - set: {Key: on}
  - request: Photo
)");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  director::dsl::Sources sources;
  const Checked checked = check("rover.yaml", world.files, sources);
  REQUIRE(checked.lowerable);
  const std::string& trace = world.outputs.files.at("run.jsonl");
  REQUIRE(trace.rfind(R"("event":"push")") > trace.find(R"("input":"cancel")"));
  TraceLines lines(trace);
  lines.next();
  const Waits waits = find_waits(lines, checked.model, lower(checked.model), sources);
  CHECK(waits.without_effect.size() == 1);
  CHECK(waits.in_force.empty());
}
