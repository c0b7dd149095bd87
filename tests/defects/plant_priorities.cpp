// Header: tests/defects/planter.hpp. Test: itself.
// SPDX-License-Identifier: MIT
//
// Who goes first, what the author relies on, and what is allowed.
#include "tests/defects/gadgets.hpp"
#include "tests/defects/planter.hpp"

namespace director::defects {

namespace {

// equal_priority

void two_roots(Robot& robot, bool defect) {
  const std::size_t p = robot.skilled_part();
  const int rank = robot.above(), other = robot.above();
  const std::string one = make(robot, "{tasks: [$0]}", {robot.skills[p][0]}),
                    two = make(robot, "{tasks: [$0]}", {robot.skills[p][1]});
  robot.add_root(one, rank);
  robot.add_root("@" + two, defect ? rank : other);
}
void two_of_a_pack(Robot& robot, bool defect) {
  const std::size_t p = robot.part();
  const std::string look = make(robot, "{tasks: [$0]}", {robot.parts[p]}),
                    nod = make(robot, "{tasks: [$0]}", {robot.parts[p]});
  const std::string report = make(robot, "{tasks: [$0]}", {nod});
  make_root(robot, "{packs: {search: {$0: {priority: 20}, @$1: {priority: $2}}}}",
            {look, report, defect ? "20" : "10"});
}
void two_purposes(Robot& robot, bool defect) {
  const std::string plan = robot.r.one_of(robot.planners).name;
  const int rank = robot.above(), other = robot.above();
  const Sense& sense = robot.sense(SenseKind::number);
  const std::string one = make(
      robot, "{providers: [{name: busy, when: [$0 > 20], packs: {go: {$1: {}}}}, {name: idle}]}", {sense.name, plan});
  const std::string two = make(robot, "{providers: [{name: busy, when: [$0 $2], packs: {go: {$1: {}}}}, {name: idle}]}",
                               {sense.name, plan, defect ? "> 10" : "<= 20"});
  robot.add_root(one, rank);
  robot.add_root("@" + two, robot.r.chance(0.5) && !defect ? other : rank);
}
void two_apart(Robot& robot, bool defect) {
  const std::size_t p = robot.skilled_part();
  make_root(robot,
            "{packs: {all: {$0: {priority: 10, apart: true}, @$1: {priority: $2, apart: true}}, other: {$1: {}}}}",
            {robot.skills[p][0], robot.skills[p][1], defect ? "10" : "5"});
}

// starved_task, optional_never_runs, priority_without_effect

/// Two new skills on a new part, which nobody else asks for.
std::vector<std::string> two_skills(Robot& robot) {
  const std::string part = robot.add_part();
  return {make(robot, "{needs: [$0]}", {part}), make(robot, "{needs: [$0]}", {part})};
}
void always_behind(Robot& robot, bool defect) {
  make_root(robot,
            defect ? "{packs: {attack: {$0: {priority: 20, apart: true}, @$1: {priority: 10}}, rest: {}}}"
                   : "{packs: {attack: {$0: {priority: 20, apart: true}, @$1: {priority: 10}}, rest: {$1: {}}}}",
            two_skills(robot));
}
void behind_further_down(Robot& robot, bool defect) {
  const std::string legs = robot.add_part(), hip = make(robot, "{needs: [$0]}", {legs});
  const std::string walk = make(robot, "{needs: [$0]}", {legs}), balance = make(robot, "{needs: [$0]}", {hip});
  const std::string walk_to = make(robot,
                                   defect ? "{needs: [$0], packs: {step: {$0: {}}, turn: {$0: {}}}}"
                                          : "{packs: {step: {$0: {}}, turn: {$0: {}}}}",
                                   {walk});
  const std::string show = make(robot, "{tasks: [@$0]}", {balance});
  make_root(robot, "{packs: {attack: {$0: {priority: 20}, $1: {priority: 10}}}}", {walk_to, show});
}
void optional_behind(Robot& robot, bool defect) {
  make_root(robot,
            defect ? "{packs: {attack: {$0: {}, @$1: {optional: true}}}}"
                   : "{packs: {attack: {$0: {}, @$1: {optional: true}}, rest: {$1: {optional: true}}}}",
            two_skills(robot));
}
void optional_in_each_pack(Robot& robot, bool defect) {
  const std::string left = robot.add_part(), right = robot.add_part();
  const std::string one = make(robot, "{needs: [$0]}", {left}), other = make(robot, "{needs: [$0]}", {right});
  const std::string dance = make(robot, "{needs: [$0, $1]}", {left, defect ? right : robot.add_part()});
  make_root(robot, "{packs: {first: {$0: {}, @$2: {optional: true}}, second: {$1: {}, $2: {optional: true}}}}",
            {one, other, dance});
}
void nobody_to_compare_with(Robot& robot, bool defect) {
  const std::size_t p = robot.part();
  make_root(robot, "{packs: {go: {@$0: {priority: $1}, $2: {}}}}",
            {robot.skills[p].front(), defect ? "7" : "0", robot.add_skill(robot.add_part())});
}
void alone_with_a_number(Robot& robot, bool defect) {
  make_root(robot, defect ? "{packs: {go: {@$0: {priority: 7}}}}" : "{packs: {go: {@$0: {}}}}",
            {robot.skills[robot.part()].front()});
}

// assertion_failed: of a small robot, for what is not proven is tried out

void assertion(Robot& robot, std::string_view text, const std::vector<std::string>& words) {
  robot.section(0, "assertions").add(flow(text, words));
}
void together_after_all(Robot& robot, bool defect) {
  const std::string legs = robot.add_part(), head = robot.add_part();
  const std::string walk = make_root(robot, "{needs: [$0], tasks: [$0]}", {legs});
  const std::string look = make_root(robot, "{needs: [$0], tasks: [$0]}", {defect ? head : legs});
  assertion(robot, "{@never_together: [$0, $1]}", {walk, look});
}
void does_not_beat(Robot& robot, bool defect) {
  const std::string legs = robot.add_part();
  const std::string walk = make_root(robot, "{needs: [$0], tasks: [$0]}", {legs});
  const std::string kick = make_root(robot, "{needs: [$0], tasks: [$0]}", {legs});
  assertion(robot, "{@beats: {$0: $1}}", {defect ? walk : kick, defect ? kick : walk});
}
void cuts_hard(Robot& robot, bool defect) {
  const std::string legs = robot.add_part(), walk = robot.verb();
  const std::string held = robot.name("Hold");
  robot.add_state(held, "{values: [free, held], initial: free, of: $0}", {walk});
  robot.add_group(walk,
                  "{providers: [{name: going, when: [$0 == free], needs: [$1], tasks: [$1]}, "
                  "{name: halting, causing: [$0 == held], sets: [$0 == free], needs: [$1], tasks: [$1]}]}",
                  {held, legs});
  const std::string kick = make(robot,
                                defect ? "{needs: [$1], tasks: [$1]}"
                                       : "{when: [$0 == held], stay: [$0 == free|held], needs: [$1], tasks: [$1]}",
                                {held, legs});
  robot.add_root(walk, robot.above());
  robot.add_root(kick, robot.above());
  assertion(robot, "{@soft: {from: $0, to: $1}}", {walk, kick});
}
void cannot_run(Robot& robot, bool defect) {
  const std::string legs = robot.add_part(), walk = make(robot, "{needs: [$0], tasks: [$0]}", {legs});
  make_root(robot,
            defect ? "{needs: [$0], packs: {go: {$1: {}}}, allow: [self_conflict], because: that is asserted}"
                   : "{packs: {go: {$1: {}}}}",
            {legs, walk});
  assertion(robot, "{@can_run: $0}", {walk});
}

// undeclared_state_write: in a scenario

void script(Robot& robot, std::string text) {
  robot.edits.push_back([text = std::move(text), main = robot.files[0].path](Texts& texts) {
    texts["trial.scenario.yaml"] = "behaviour: " + main + "\n" + text;
  });
}
void set_by_a_body(Robot& robot, bool defect) {
  const std::string name = make_root(robot, "{sets: [$0 == second]}", {robot.inner});
  script(robot, fill("script:\n  $0:\n    @set: {$1: $2}\nsteps:\n  - request: $0\n",
                     {name, robot.inner, defect ? "never" : "second"}));
}
void set_when_stopped(Robot& robot, bool defect) {
  const std::string name = make_root(robot, "{start: {sets: [$0 == second]}, stop: true}", {robot.inner});
  script(robot, fill("script:\n  $0.$2:\n    @set: {$1: second}\nsteps:\n  - request: $0\n  - cancel: $0\n",
                     {name, robot.inner, defect ? "stop" : "start"}));
}
void set_by_a_step(Robot& robot, bool defect) {
  const Sense& sense = robot.sense(SenseKind::plain);
  script(robot, fill("steps:\n  - request: $0\n  - @set: {$1: $2}\n",
                     {robot.owner, defect ? robot.owned : sense.name, defect ? "half" : sense.values[1]}));
}

// unreachable_case

void behind_what_waits_for_less(Robot& robot, bool defect) {
  const std::string name = make_root(robot, "{}", {});
  script(robot, fill("script:\n  $0:\n    - {$1wait: 1 s}\n    - @{run: 1, done: true}\nsteps:\n  - request: $0\n",
                     {name, defect ? "" : "run: 2, "}));
}
void for_a_push_that_never_comes(Robot& robot, bool defect) {
  const std::string name = make_root(robot, "{}", {});
  script(robot, fill("script:\n  $0:\n    - @{reason: $1, done: true}\nsteps:\n  - request: $0\n",
                     {name, defect ? "pushed" : "new_task"}));
}
void for_no_provider(Robot& robot, bool defect) {
  const std::string name = make_root(robot, "{}", {});
  script(robot, fill("script:\n  @$0: {done: true}\n$1steps:\n  - request: $0\n",
                     {name, defect ? "  " + name + ".default: {wait: 1 s}\n" : ""}));
}

// unused_allow: in an imported file it might be for another behaviour

void allows_nothing(Robot& robot, bool defect) {
  const std::string name = robot.name("Rest");
  Node& group = robot.section(0, "groups").add(name, flow("{uses: []}"));
  if (defect) {
    group.add("allow", flow("[@$0]", {robot.r.one_of({"starved_task", "ordering_on_sentinel", "push_cycle"})}));
    group.add("because", "it was so once");
  }
  robot.add_root(name, robot.above());
}
void allows_an_error(Robot& robot, bool defect) {
  const std::string name =
      make_root(robot, "{when: [$0], because: it waits}", {condition(robot.r, robot.sense(SenseKind::plain))});
  robot.group(name).add("allow", flow(defect ? "[uncovered_state, @needs_conflict]" : "[@uncovered_state]"));
}
void allowed_in_a_state(Robot& robot, bool defect) {
  Node& state = robot.section(0, "states").add(robot.name("Weather"), flow("{values: [dry, wet], external: true}"));
  if (!defect) return;
  state.add("allow", flow("[@yaml_word_trap]"));
  state.add("because", "words are words");
}
void allowed_for_a_file(Robot& robot, bool defect) {
  if (!defect) return;
  robot.section(0, "allow") = flow("[@possible_pack_conflict]");
  robot.section(0, "because") = Node("nobody minds");
}

constexpr Planter of_priorities[]{
    {"equal_priority", "two roots", two_roots},
    {"equal_priority", "two of a pack", two_of_a_pack},
    {"equal_priority", "two purposes", two_purposes},
    {"equal_priority", "two apart", two_apart},
    {"starved_task", "always behind", always_behind},
    {"starved_task", "further down", behind_further_down},
    {"optional_never_runs", "behind", optional_behind},
    {"optional_never_runs", "in each pack", optional_in_each_pack},
    {"priority_without_effect", "nobody to compare with", nobody_to_compare_with},
    {"priority_without_effect", "alone", alone_with_a_number},
    {"assertion_failed", "never_together", together_after_all},
    {"assertion_failed", "beats", does_not_beat},
    {"assertion_failed", "soft", cuts_hard},
    {"assertion_failed", "can_run", cannot_run},
    {"undeclared_state_write", "a body", set_by_a_body},
    {"undeclared_state_write", "a handler", set_when_stopped},
    {"undeclared_state_write", "a step", set_by_a_step},
    {"unreachable_case", "behind one that waits for less", behind_what_waits_for_less},
    {"unreachable_case", "a push", for_a_push_that_never_comes},
    {"unreachable_case", "no provider", for_no_provider},
    {"unused_allow", "nothing", allows_nothing},
    {"unused_allow", "an error", allows_an_error},
    {"unused_allow", "in a state", allowed_in_a_state},
    {"unused_allow", "a file", allowed_for_a_file},
};

} // namespace

std::span<const Planter> priority_planters() { return of_priorities; }

} // namespace director::defects
