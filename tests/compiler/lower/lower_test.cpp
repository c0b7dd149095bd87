// SPDX-License-Identifier: MIT
#include "compiler/lower/lower.hpp"
#include "compiler/lower/steps.hpp"
#include "tests/compiler/support/compiled.hpp"

using namespace director;
using namespace director::compiler;
using director::tests::compile;
using director::tests::Compiled;

namespace {

const director::Provider& provider_row(const Compiled& c, const Lowered& lowered, const std::string& name) {
  return lowered.providers[c.provider(name).value];
}

std::vector<std::string> conditions(const Compiled& c, const Lowered& lowered, Range range) {
  std::vector<std::string> out;
  for (const Index condition : lowered.view().list(range)) {
    out.push_back(c.model.conditions[lowered.condition_ids[condition]].text);
  }
  return out;
}

std::vector<std::string> providers(const Compiled& c, std::span<const Index> rows) {
  std::vector<std::string> out;
  for (const Index provider : rows) out.push_back(c.model.full_name(ProviderId{provider}));
  return out;
}

std::vector<std::string> groups(const Compiled& c, std::span<const Index> rows) {
  std::vector<std::string> out;
  for (const Index group : rows) out.push_back(c.model.groups[GroupId{group}].name.value);
  return out;
}

using Texts = std::vector<std::string>;

} // namespace

TEST_CASE("levels are ranked per requester: mandatory before optional, then the higher priority") {
  const Compiled c = compile(R"(
behaviour: ranks
language: 1
roots: {Boss: {}}
groups:
  Boss:
    needs: [D]
    tasks:
      A: {priority: 10}
      B: {levels: {firm: {priority: 50}, spare: {priority: 50, optional: true}, low: {priority: -5}}}
      C: {priority: 10, apart: true}
  A: {}
  B: {}
  C: {}
  D: {}
)");
  const Lowered lowered = lower(c.model);
  const auto levels = [&](const std::string& edge) {
    const Range range = lowered.edges[c.edge(edge).value].levels;
    return std::vector<director::Level>(lowered.levels.begin() + range.begin, lowered.levels.begin() + range.end);
  };
  REQUIRE(levels("Boss>A").size() == 1);
  CHECK(levels("Boss>A")[0].urgency == 1);
  CHECK(!levels("Boss>A")[0].apart);
  REQUIRE(levels("Boss>B").size() == 3);
  CHECK(levels("Boss>B")[0].urgency == 0);
  CHECK(levels("Boss>B")[1].urgency == 0);
  CHECK(levels("Boss>B")[1].optional);
  CHECK(levels("Boss>B")[2].urgency == 3); // behind the 0 of the need
  REQUIRE(levels("Boss>C").size() == 1);
  CHECK(levels("Boss>C")[0].urgency == 1); // as that of A
  CHECK(levels("Boss>C")[0].apart);
  CHECK(levels("Boss>D").empty());
  CHECK(lowered.edges[c.edge("Boss>A").value].need_urgency == 1);
  CHECK(lowered.edges[c.edge("Boss>B").value].need_urgency == 0);
  CHECK(lowered.edges[c.edge("Boss>D").value].need_urgency == 2); // a need without a request counts 0
  CHECK(lowered.root_edges == 1);
  CHECK(lowered.most_edges == 4);
  CHECK(lowered.edges[c.edge("root>Boss").value].requester == nil);
}

TEST_CASE("only conditions that providers wait for, or promise within a time, have a row") {
  const Compiled c = compile(R"(
behaviour: conditions
language: 1
states:
  Pose: {values: [lying, standing, running], initial: lying}
  Load: {range: [0, 9], external: true, expires: {after: 2 s, to: 3}}
triggers: [Bell]
roots: [Kick, Walk]
groups:
  Kick: {when: [Pose == standing, Load != 3|5], stay: [Pose >= standing]}
  Walk:
    triggers: [Bell]
    providers:
      - {name: slow, causing: [Pose == standing within 10 ms], sets: [Pose == running]}
      - {name: fast, causing: [Pose == standing|running, Load < 2], triggers: [Walk.slow.broken], every: 20 ms}
)");
  const Lowered lowered = lower(c.model);
  Texts all;
  for (const ConditionId id : lowered.condition_ids) all.push_back(c.model.conditions[id].text);
  CHECK(all == Texts{"Pose == standing", "Load != 3|5", "Pose >= standing"});
  const auto causers = [&](std::size_t row) {
    return providers(c, lowered.view().list(lowered.conditions[row].causers));
  };
  CHECK(causers(0) == Texts{"Walk.slow"});
  CHECK(causers(1) == Texts{"Walk.fast"});
  CHECK(causers(2) == Texts{"Walk.slow", "Walk.fast"});
  const Range accepts = lowered.conditions[1].accepts;
  REQUIRE(accepts.size() == 3);
  CHECK(lowered.intervals[accepts.begin].low == 0);
  CHECK(lowered.intervals[accepts.begin].high == 2);
  CHECK(lowered.intervals[accepts.begin + 1].low == 4);
  CHECK(lowered.intervals[accepts.begin + 2].high == 9);

  CHECK(conditions(c, lowered, provider_row(c, lowered, "Kick").when) == Texts{"Pose == standing", "Load != 3|5"});
  CHECK(conditions(c, lowered, provider_row(c, lowered, "Kick").stay) == Texts{"Pose >= standing"});
  CHECK(conditions(c, lowered, provider_row(c, lowered, "Walk.fast").effects) ==
        Texts{"Load != 3|5", "Pose >= standing"});
  CHECK(lowered.view().list(provider_row(c, lowered, "Walk.fast").causing).size() == 2);
  CHECK(provider_row(c, lowered, "Walk.fast").every == 20'000);
  REQUIRE(lowered.components.size() == 1);

  REQUIRE(lowered.promises.size() == 1);
  CHECK(lowered.promises[0].within == 10'000);
  CHECK(lowered.promises[0].provider == c.provider("Walk.slow").value);
  CHECK(c.model.triggers[TriggerId{lowered.promises[0].trigger}].name == "Walk.slow.broken");
  CHECK(providers(c, lowered.view().list(lowered.triggers[0].listeners)) == Texts{"Walk.slow", "Walk.fast"});
  CHECK(providers(c, lowered.view().list(lowered.triggers[1].listeners)) == Texts{"Walk.fast"});
  CHECK(lowered.groups[c.group("Walk").value].listens.size() == 2);
  CHECK(lowered.groups[c.group("Kick").value].listens.empty());

  CHECK(lowered.states[0].initial == 0);
  CHECK(lowered.states[1].initial == unset);
  CHECK(lowered.states[1].expires == 2'000'000);
  CHECK(lowered.states[1].expires_to == 3);
  CHECK(lowered.states[1].external);
}

TEST_CASE("a promise without a listener fires nothing") {
  const Compiled c = compile(R"(
behaviour: quiet
language: 1
states: {Pose: {values: [lying, standing]}}
roots: [Kick, Walk]
groups:
  Kick: {when: [Pose == standing]}
  Walk: {causing: [Pose == standing within 1 min]}
)");
  const Lowered lowered = lower(c.model);
  REQUIRE(lowered.promises.size() == 1);
  CHECK(lowered.promises[0].trigger == nil);
  CHECK(lowered.promises[0].within == 60'000'000);
}

TEST_CASE("a plan has a slot for each group with a choice among all that its owner may need") {
  const Compiled c = compile(R"(
behaviour: slots
language: 1
states:
  Step: {values: [one, two], initial: one, of: Walk}
  Pose: {values: [lying, standing], external: true}
roots: [Walk, Sit]
groups:
  Walk:
    start: true
    needs: [Gait]
    tasks: [Gait]
    sets: [Step]
  Gait:
    providers:
      - {name: legs, needs: [Leg]}
      - {name: wheels, needs: [Motor]}
  Leg: {providers: [{name: strong}, {name: weak}]}
  Motor: {}
  Sit: {stop: true, needs: [Leg], when: [Pose == lying]}
)");
  const Lowered lowered = lower(c.model);
  const auto slots = [&](const std::string& name) {
    const Range range = lowered.groups[c.group(name).value].slots;
    return groups(c, std::span(lowered.plan_groups).subspan(range.begin, range.size()));
  };
  CHECK(slots("Walk") == Texts{"Gait", "Leg"});
  CHECK(slots("Gait") == Texts{"Leg"});
  CHECK(slots("Leg").empty());
  CHECK(slots("Sit") == Texts{"Leg"});
  const director::Group& walk = lowered.groups[c.group("Walk").value];
  CHECK(walk.start);
  CHECK(!walk.stop);
  CHECK(lowered.groups[c.group("Sit").value].stop);
  REQUIRE(walk.owned.size() == 1);
  CHECK(lowered.view().list(walk.owned)[0] == 0);
  CHECK(lowered.states[0].owner == c.group("Walk").value);
  CHECK(lowered.states[1].owner == nil);
  const director::Group& leg = lowered.groups[c.group("Leg").value];
  CHECK(leg.providers.size() == 2);
  CHECK(leg.edges.empty());
  CHECK(leg.requesters.size() == 2);
  const Range needs = provider_row(c, lowered, "Gait.wheels").needs;
  REQUIRE(needs.size() == 1);
  CHECK(lowered.view().list(needs)[0] == c.edge("Gait>Motor").value);
}

TEST_CASE("a causing provider aims at what it and the providers of its plans wait for") {
  const Compiled c = compile(R"(
behaviour: aims
language: 1
states:
  Pose: {values: [lying, standing], external: true}
  Load: {range: [0, 9], external: true}
  Heat: {range: [0, 9], external: true}
roots: [Kick, Halt]
groups:
  Kick: {when: [Pose == standing]}
  Halt:
    providers:
      - {name: softly, when: [Load < 5], stay: [Load < 7], needs: [Leg, Arm], causing: [Pose == standing]}
      - {name: idly, when: [Load > 1]}
  Leg: {providers: [{name: strong, when: [Heat < 5]}, {name: weak, needs: [Arm], when: [Heat < 9]}]}
  Arm: {when: [Heat > 0]}
)");
  const Lowered lowered = lower(c.model);
  // Leg.weak needs the arm that Halt needs as well: no plan picks it.
  CHECK(conditions(c, lowered, provider_row(c, lowered, "Halt.softly").aims) ==
        Texts{"Load < 5", "Load < 7", "Heat < 5", "Heat > 0"});
  CHECK(provider_row(c, lowered, "Halt.idly").aims.empty());
  CHECK(lowered.wide_aims.empty());
}

TEST_CASE("a group is used by itself and by all in whose plans it may be, a condition by the groups that wait for it") {
  const Compiled c = compile(R"(
behaviour: uses
language: 1
states:
  Pose: {values: [lying, standing], external: true}
  Load: {range: [0, 9], external: true}
roots: [Kick, Halt]
groups:
  Kick: {when: [Pose == standing], needs: [Leg], tasks: [Leg]}
  Halt:
    providers:
      - {name: softly, stay: [Pose == standing], when: [Load > 1], tasks: [Leg]}
      - {name: idly, when: [Pose == standing]}
  Leg: {providers: [{name: strong, when: [Load < 5], needs: [Motor]}, {name: weak}]}
  Motor: {}
)");
  const Lowered lowered = lower(c.model);
  const auto users = [&](const char* name) {
    return groups(c, lowered.view().list(lowered.groups[c.group(name).value].users));
  };
  CHECK(users("Kick") == Texts{"Kick"});
  CHECK(users("Halt") == Texts{"Halt"}); // it requests the leg and does not need it
  CHECK(users("Leg") == Texts{"Kick", "Leg"});
  CHECK(users("Motor") == Texts{"Kick", "Leg", "Motor"});
  const auto waiting = [&](const std::string& text) {
    for (Index i = 0; i < lowered.conditions.size(); ++i) {
      if (c.model.conditions[lowered.condition_ids[i]].text == text)
        return groups(c, lowered.view().list(lowered.conditions[i].groups));
    }
    return Texts{"there is no such condition"};
  };
  CHECK(waiting("Pose == standing") == Texts{"Kick", "Halt"});
  CHECK(waiting("Load < 5") == Texts{"Leg"});
}

TEST_CASE("a change of what is promised within a time is looked at, though nothing waits for just that") {
  const Compiled c = compile(R"(
behaviour: promising
language: 1
states: {Pose: {values: [moving, slow, still], initial: moving}}
roots: {Kick: {priority: 20}, Walk: {priority: 10}, Look: {priority: 5}}
groups:
  Look: {}
  Kick: {when: [Pose != moving]}
  Walk:
    providers:
      - {name: walking, sets: [Pose == moving]}
      - {name: halting, causing: [Pose == still within 2 s]}
)");
  const Lowered lowered = lower(c.model);
  REQUIRE(lowered.components.size() == 2);
  REQUIRE(lowered.promises.size() == 1);
  const std::span<const Index> components =
      lowered.view().list(lowered.conditions[lowered.promises[0].condition].components);
  CHECK(std::vector<Index>(components.begin(), components.end()) ==
        std::vector<Index>{lowered.groups[c.group("Walk").value].component});
}
