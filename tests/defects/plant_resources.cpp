// Header: tests/defects/planter.hpp. Test: itself.
// SPDX-License-Identifier: MIT
//
// Needs, and what is granted together.
#include "tests/defects/gadgets.hpp"
#include "tests/defects/planter.hpp"

namespace director::defects {

namespace {

std::string two_ways(Robot& robot, const std::string& left, const std::string& right) {
  return make(robot, "{providers: [{name: by_left, needs: [$0]}, {name: by_right, needs: [$1]}]}", {left, right});
}

// needs_cycle: any line of the circle is right

void part_needs_skill(Robot& robot, bool defect) {
  const std::string part = robot.add_part();
  const std::string skill = make_root(robot, "{needs: [@$0], tasks: [$0]}", {part});
  if (defect) robot.group(part).add("needs", flow("[@$0]", {skill}));
}
void needs_itself(Robot& robot, bool defect) {
  const std::string part = robot.add_part(), name = make_root(robot, "{}");
  robot.group(name).add("needs", flow("[@$0]", {defect ? name : part}));
}
void longer_circle(Robot& robot, bool defect) {
  const std::string last = make(robot, "{}");
  const std::string middle = make(robot, "{needs: [@$0]}", {last});
  const std::string first = make_root(robot, "{needs: [@$0]}", {middle});
  Node& end = robot.group(last);
  Node& list = end.add("providers", Node::list());
  list.add(flow(defect ? "{name: firmly, needs: [@$0]}" : "{name: firmly}", {first}));
}

// needs_conflict

void whole_and_half(Robot& robot, bool defect) {
  const std::string whole = robot.parts[robot.whole_part()], other = robot.add_part();
  make_root(robot, "{needs: [$0, @$1]}", {whole, defect ? "Left" + whole : other});
}
void skill_and_part(Robot& robot, bool defect) {
  const std::size_t p = robot.skilled_part();
  const std::string other = robot.add_part();
  make_root(robot, "{needs: [$0, @$1]}", {robot.skills[p].front(), defect ? robot.parts[p] : other});
}
void needed_twice(Robot& robot, bool defect) {
  const std::string part = robot.parts[robot.part()], other = robot.add_part();
  make_root(robot, "{needs: [$0, @$1]}", {part, defect ? part : other});
}
void two_skills_of_a_part(Robot& robot, bool defect) {
  const std::size_t p = robot.skilled_part();
  const std::string other = robot.add_part();
  const std::string deep = make(robot, "{needs: [$0]}", {robot.skills[p][1]});
  make_root(robot, "{needs: [$0, @$1]}", {robot.skills[p][0], defect ? deep : other});
}
void three_for_two(Robot& robot, bool defect) {
  const std::string left = robot.add_part(), right = robot.add_part(), third = robot.add_part();
  const std::string a = two_ways(robot, left, right), b = two_ways(robot, left, right);
  const std::string c = two_ways(robot, left, defect ? right : third);
  make_root(robot, "{needs: [@$0, $1, $2]}", {a, b, c});
}

// pack_conflict

void two_on_one_part(Robot& robot, bool defect) {
  const std::size_t p = robot.skilled_part();
  const std::string other = robot.add_skill(robot.add_part());
  make_root(robot, "{packs: {both: {$0: {priority: 20}, @$1: {priority: 10}}}}",
            {robot.skills[p][0], defect ? robot.skills[p][1] : other});
}
void in_a_planner(Robot& robot, bool defect) {
  const std::size_t p = robot.skilled_part();
  const std::string other = robot.add_skill(robot.add_part());
  Node& pack = robot.add_pack(robot.r.one_of(robot.planners).name, robot.name("both"));
  pack.add(robot.skills[p][0], flow("{priority: 30}"));
  pack.add("@" + (defect ? robot.skills[p][1] : other), flow("{priority: 20}"));
}
void with_its_part(Robot& robot, bool defect) {
  const std::size_t p = robot.part();
  const std::string other = robot.add_part();
  make_root(robot, "{packs: {both: {$0: {priority: 20}, @$1: {priority: 10}}}}",
            {robot.skills[p].front(), defect ? robot.parts[p] : other});
}
void excluding_conditions(Robot& robot, bool defect) {
  const Sense& sense = robot.sense(SenseKind::plain);
  const std::string one = robot.add_part(), two = robot.add_part();
  const std::string a = make(robot, "{when: [$0 == $1], needs: [$2], allow: [uncovered_state], because: it waits}",
                             {sense.name, sense.values[1], one});
  const std::string b = make(robot, "{when: [$0 == $1], needs: [$2], allow: [uncovered_state], because: it waits}",
                             {sense.name, sense.values[defect ? 2 : 1], two});
  make_root(robot, "{packs: {both: {$0: {priority: 20}, @$1: {priority: 10}}}}", {a, b});
}
void three_members_for_two(Robot& robot, bool defect) {
  const std::string left = robot.add_part(), right = robot.add_part(), third = robot.add_part();
  const std::string a = two_ways(robot, left, right), b = two_ways(robot, left, right);
  const std::string c = two_ways(robot, left, defect ? right : third);
  // Beside the others it has but one way: by itself it has both.
  make_root(robot,
            defect ? "{packs: {all: {$0: {}, $1: {}, @$2: {}}}}"
                   : "{packs: {all: {$0: {}, $1: {}, @$2: {}}, alone: {$2: {}}}}",
            {a, b, c});
}

// possible_pack_conflict

void flat_list(Robot& robot, bool defect) {
  const std::size_t p = robot.skilled_part();
  make_root(robot,
            defect ? "{tasks: {$0: {priority: 20}, @$1: {priority: 10}}}"
                   : "{packs: {one: {$0: {priority: 20}}, other: {@$1: {priority: 10}}}}",
            {robot.skills[p][0], robot.skills[p][1]});
}
void preferred_in_the_way(Robot& robot, bool defect) {
  const std::string left = robot.add_part(), right = robot.add_part();
  const std::string carry =
      make(robot, "{providers: [{name: both_hands, needs: [$0, $1]}, {name: one_hand, needs: [$1]}]}", {left, right});
  const std::string wave = make(robot, "{needs: [$0]}", {left});
  make_root(robot,
            defect ? "{packs: {greet: {$0: {priority: 20}, @$1: {priority: 10}}}}"
                   : "{packs: {greet: {$0: {priority: 10}, @$1: {priority: 20, apart: true}}, carry: {$0: {}}}}",
            {carry, wave});
}
void only_while(Robot& robot, bool defect) {
  const Sense& sense = robot.sense(SenseKind::plain);
  const std::string left = robot.add_part(), right = robot.add_part();
  const std::string carry =
      make(robot, "{providers: [{name: one_hand, when: [$0 == $1], needs: [$2]}, {name: both_hands, needs: [$3, $2]}]}",
           {sense.name, sense.values[1], right, defect ? left : robot.add_part()});
  const std::string wave = make(robot, "{needs: [$0]}", {left});
  make_root(robot, "{packs: {greet: {$0: {priority: 20}, @$1: {priority: 10}}}}", {wave, carry});
}

// undeclared_need, unreserved_tasks, unused_need

void half_reserved(Robot& robot, bool defect) {
  const std::string own = robot.add_part(), wanted = robot.parts[robot.part()];
  make_root(robot, "{needs: [$0]}", {wanted});
  const std::string fetch =
      make(robot, defect ? "{needs: [$0], tasks: [$0, @$1]}" : "{needs: [$0, $1], tasks: [$0, @$1]}", {own, wanted});
  robot.add_root(fetch, robot.below());
}
void half_reserved_in_a_pack(Robot& robot, bool defect) {
  const std::string own = robot.add_part(), other = robot.add_part();
  const std::string guide = make(robot,
                                 defect ? "{needs: [$0], packs: {all: {$0: {}, @$1: {}}, some: {$0: {}}}}"
                                        : "{needs: [$0, $1], packs: {all: {$0: {}, @$1: {}}, some: {$0: {}}}}",
                                 {own, other});
  const std::string drive = make(robot, "{tasks: [$0]}", {other});
  make_root(robot, "{packs: {both: {$0: {priority: 20}, $1: {priority: 10, apart: true}}}}", {drive, guide});
}
void not_reserved(Robot& robot, bool defect) {
  const std::string wanted = robot.parts[robot.part()];
  make_root(robot, "{needs: [$0]}", {wanted});
  const std::string fetch = make(robot, defect ? "{tasks: [@$0]}" : "{needs: [$0], tasks: [@$0]}", {wanted});
  robot.add_root(fetch, robot.below());
}
void never_requested(Robot& robot, bool defect) {
  const std::string own = robot.parts[robot.part()], idle = robot.add_part();
  make_root(robot, defect ? "{needs: [$0, @$1], tasks: [$0]}" : "{needs: [$0, @$1], tasks: [$0, $1]}", {own, idle});
}

// self_conflict, sibling_starvation, useless_use

void keeps_from_its_task(Robot& robot, bool defect) {
  const std::size_t p = robot.part();
  make_root(robot, defect ? "{needs: [$0], tasks: [@$1]}" : "{needs: [$1], tasks: [@$1]}",
            {robot.parts[p], robot.skills[p].front()});
}
void keeps_from_below(Robot& robot, bool defect) {
  const std::size_t p = robot.part();
  const std::string between = make(robot, "{packs: {go: {$0: {}}}}", {robot.skills[p].front()});
  make_root(robot, defect ? "{needs: [$0], packs: {go: {@$1: {}}}}" : "{needs: [$2], packs: {go: {@$1: {}}}}",
            {robot.parts[p], between, robot.add_part()});
}
void before_what_is_below(Robot& robot, bool defect) {
  const std::size_t p = robot.skilled_part();
  const std::string aim = make(robot, "{tasks: [$0]}", {robot.skills[p][0]});
  make_root(robot,
            defect ? "{packs: {attack: {$0: {priority: 20}, @$1: {priority: 10}}}}"
                   : "{packs: {attack: {$0: {priority: 10}, @$1: {priority: 20, apart: true}}, rest: {$0: {}}}}",
            {aim, robot.skills[p][1]});
}
void the_same_below(Robot& robot, bool defect) {
  const std::size_t p = robot.part();
  const std::string skill = robot.skills[p].front();
  const std::string aim = make(robot, "{tasks: [$0]}", {defect ? skill : robot.add_skill(robot.add_part())});
  make_root(robot, "{packs: {attack: {$0: {priority: 20}, @$1: {priority: 10}}}}", {aim, skill});
}
void foreign_use(Robot& robot, bool defect) {
  const std::size_t p = robot.skilled_part();
  make_root(robot, defect ? "{tasks: [$0], uses: [@$1]}" : "{tasks: [$0], uses: [@$0]}",
            {robot.skills[p][0], robot.skills[p][1]});
}
void use_beside_providers(Robot& robot, bool defect) {
  const Sense& sense = robot.sense(SenseKind::plain);
  const std::string part = robot.parts[robot.part()], other = robot.add_part();
  make_root(robot, "{uses: [@$0], providers: [{name: one, when: [$1 == $2], tasks: [$3]}, {name: other}]}",
            {defect ? other : part, sense.name, sense.values[1], part});
}

// waiting_company, hard_hand_over, task_cycle, unbounded_choice

void idle_company(Robot& robot, bool defect) {
  const Sense& sense = robot.sense(SenseKind::plain);
  const std::string one = robot.add_part(), two = robot.add_part();
  const std::string kick = make(robot, "{when: [$0 == $1], needs: [$2], allow: [uncovered_state], because: it waits}",
                                {sense.name, sense.values[1], one});
  const std::string look = make(robot, "{needs: [$0]}", {two});
  make_root(robot,
            defect ? "{packs: {attack: {$0: {priority: 20}, @$1: {priority: 10}}}}"
                   : "{packs: {attack: {$0: {priority: 20}, @$1: {priority: 10, apart: true}}}}",
            {kick, look});
}
void beside_a_delicate_one(Robot& robot, bool defect) {
  const Pair& pair = robot.r.one_of(robot.pairs);
  const std::string look = robot.add_skill(robot.add_part());
  make_root(robot,
            defect ? "{packs: {attack: {$0: {priority: 20}, $1: {priority: 10, apart: true}, @$2: {}}}}"
                   : "{packs: {attack: {$0: {priority: 20}, $1: {priority: 10, apart: true}, @$2: {apart: true}}}}",
            {pair.delicate, pair.resting, look});
}
void between_planners(Robot& robot, bool defect) {
  const std::string walk = make(robot, "{stop: true, needs: [$0], tasks: [$0]}", {robot.parts[robot.part()]});
  const std::string other = robot.add_skill(robot.add_part());
  const std::string one = make(robot, "{packs: {step: {$0: {}}}}", {walk});
  const std::string two = make(robot,
                               defect ? "{packs: {line_up: {$0: {}}, kick: {$1: {}}}}"
                                      : "{packs: {line_up: {$0: {}}, kick: {$0: {}, $1: {}}}}",
                               {walk, other});
  make_root(robot, "{packs: {approach: {$0: {}}, attack: {@$1: {}}}}", {one, two});
}
void asks_for_itself(Robot& robot, bool defect) {
  const std::string part = robot.parts[robot.part()];
  const std::string name = make_root(robot, "{}");
  Node& tasks = robot.group(name).add("tasks", Node::list());
  tasks.add(part);
  tasks.add("@" + (defect ? name : robot.add_part()));
}
void asks_for_its_requester(Robot& robot, bool defect) {
  const std::string last = make(robot, "{}");
  const std::string middle = make(robot, "{tasks: [@$0]}", {last});
  const std::string first = make_root(robot, "{packs: {go: {@$0: {}}}}", {middle});
  robot.group(last).add("tasks", flow("{@$0: {}}", {defect ? first : robot.add_part()}));
}
/// `last`: a part that only the last way needs besides; empty: none.
std::string many_ways(Robot& robot, const std::string& part, const std::string& last = {}) {
  const std::string name = make(robot, "{providers: []}");
  Node& list = *robot.group(name).find("providers");
  const std::string number = robot.sense(SenseKind::number).name;
  for (int i = 1; i < 12; ++i) {
    list.add(flow("{name: way$0, when: [$1 == $0], needs: [$2]}", {std::to_string(i), number, part}));
  }
  list.add(last.empty() ? flow("{name: otherwise, needs: [$0]}", {part})
                        : flow("{name: otherwise, needs: [$0, $1]}", {part, last}));
  return name;
}
/// Two tasks, each with 144 plans, in one of which both need the same part.
void many_members(Robot& robot, bool defect) {
  Node pack;
  const std::string shared = defect ? robot.add_part() : "";
  for (int i = 0; i < 2; ++i) {
    Node needs = Node::list();
    needs.add(many_ways(robot, robot.add_part()));
    needs.add(many_ways(robot, robot.add_part(), shared));
    const std::string name = make(robot, "{}");
    robot.group(name).add("needs", needs);
    pack.add(i == 0 ? "@" + name : name, flow(defect || i == 0 ? "{}" : "{apart: true}"));
  }
  const std::string boss = make_root(robot, "{packs: {}}");
  robot.group(boss).find("packs")->add("all", pack);
}
void many_needs(Robot& robot, bool defect) {
  Node needs = Node::list();
  for (int i = 0; i < (defect ? 4 : 2); ++i) needs.add(many_ways(robot, robot.add_part()));
  const std::string boss = make(robot, "{}");
  robot.group(boss).add("needs", needs);
  robot.add_root("@" + boss, robot.above());
}

constexpr Planter of_resources[]{
    {"needs_cycle", "a part and a skill", part_needs_skill},
    {"needs_cycle", "itself", needs_itself},
    {"needs_cycle", "three in a circle", longer_circle},
    {"needs_conflict", "the whole and a half", whole_and_half},
    {"needs_conflict", "a skill and its part", skill_and_part},
    {"needs_conflict", "twice", needed_twice},
    {"needs_conflict", "two skills of one part", two_skills_of_a_part},
    {"needs_conflict", "three for two", three_for_two},
    {"pack_conflict", "two skills of one part", two_on_one_part},
    {"pack_conflict", "in a planner", in_a_planner},
    {"pack_conflict", "a skill and its part", with_its_part},
    {"pack_conflict", "conditions", excluding_conditions},
    {"pack_conflict", "three for two", three_members_for_two},
    {"possible_pack_conflict", "a flat list", flat_list},
    {"possible_pack_conflict", "the preferred provider", preferred_in_the_way},
    {"possible_pack_conflict", "only while", only_while},
    {"undeclared_need", "a root above", half_reserved},
    {"undeclared_need", "in a pack", half_reserved_in_a_pack},
    {"unreserved_tasks", "a root above", not_reserved},
    {"unused_need", "never requested", never_requested},
    {"self_conflict", "its task", keeps_from_its_task},
    {"self_conflict", "further down", keeps_from_below},
    {"sibling_starvation", "what is below", before_what_is_below},
    {"sibling_starvation", "the same group", the_same_below},
    {"useless_use", "of another", foreign_use},
    {"useless_use", "beside providers", use_beside_providers},
    {"waiting_company", "for the outside", idle_company},
    {"waiting_company", "for a push", beside_a_delicate_one},
    {"hard_hand_over", "between planners", between_planners},
    {"task_cycle", "itself", asks_for_itself},
    {"task_cycle", "its requester", asks_for_its_requester},
    {"unbounded_choice", "members", many_members},
    {"unbounded_choice", "needs", many_needs},
};

} // namespace

std::span<const Planter> resource_planters() { return of_resources; }

} // namespace director::defects
