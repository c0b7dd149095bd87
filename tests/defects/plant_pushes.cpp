// Header: tests/defects/planter.hpp. Test: itself.
// SPDX-License-Identifier: MIT
//
// Promises, and pushes for them.
#include "tests/defects/gadgets.hpp"
#include "tests/defects/planter.hpp"

namespace director::defects {

namespace {

// unreachable_causing

void nobody_asks(Robot& robot, bool defect) {
  const std::string state = make_state(robot, "loose", "tight");
  const std::string waits = make_root(robot, "{when: [$0 == tight]}", {state});
  const std::string causes = make(
      robot, "{providers: [{name: going, sets: [$0 == loose]}, {name: coming, causing: [@$0 == tight]}]}", {state});
  if (!defect) robot.add_root(causes, robot.below());
  (void)waits;
}
void never_its_turn(Robot& robot, bool defect) {
  const std::string first = make_state(robot, "shut", "open"), second = make_state(robot, "dark", "bright");
  const std::string waits = make(robot, "{when: [$0 == open]}", {first});
  const std::string causes = make(robot, "{when: [$0 == bright], causing: [@$1 == open]}", {second, first});
  const std::string lamp = make(robot, "{sets: [$0 == bright]}", {second});
  ask_for_both(robot, waits, causes);
  if (!defect) robot.add_root(lamp, robot.above());
  if (!defect)
    robot.group(causes).add("allow", flow("[uncovered_state]")), robot.group(causes).add("because", "the lamp decides");
}
void the_lowest_one(Robot& robot, bool defect) {
  const std::string first = make_state(robot, "shut", "open"), second = make_state(robot, "lost", "found");
  const std::string waits = make(robot, "{when: [$0 == open]}", {first});
  const std::string middle = make(robot, "{when: [$0 == found], causing: [$1 == open]}", {second, first});
  const std::string last = make(robot, "{causing: [@$0 == found]}", {second});
  ask_for_both(robot, waits, middle);
  if (!defect) robot.add_root(last, robot.above());
}
void only_below_itself(Robot& robot, bool defect) {
  const std::string state = make_state(robot, "shut", "open");
  const std::string winch = make(robot, "{causing: [@$0 == open]}", {state});
  make_root(robot, "{when: [$0 == open], tasks: [$1]}", {state, winch});
  if (!defect) robot.add_root(winch, robot.below());
}

// unpushable_causing

void goes_before(Robot& robot, bool defect) {
  const std::string state = make_state(robot, "moving", "standing");
  const std::string waits = make(robot, "{when: [$0 == standing]}", {state});
  const std::string walk = make(
      robot, "{providers: [{name: going, sets: [$0 == moving]}, {name: coming, causing: [@$0 == standing]}]}", {state});
  const int low = robot.above(), high = robot.above();
  robot.add_root(waits, defect ? low : high);
  robot.add_root(walk, defect ? high : low);
}
void one_unit(Robot& robot, bool defect) {
  const std::string state = make_state(robot, "moving", "standing");
  const std::string waits = make(robot, "{when: [$0 == standing]}", {state});
  const std::string aim = make(robot, "{tasks: [$0]}", {waits});
  const std::string walk = make(
      robot, "{providers: [{name: going, sets: [$0 == moving]}, {name: coming, causing: [@$0 == standing]}]}", {state});
  make_root(robot,
            defect ? "{packs: {both: {$0: {priority: 10}, $1: {priority: 20}}}}"
                   : "{packs: {both: {$0: {priority: 10, apart: true}, $1: {priority: 20}}}}",
            {walk, aim});
}
void below_the_task(Robot& robot, bool defect) {
  const std::string state = make_state(robot, "moving", "standing");
  const std::string walk = make(
      robot, "{providers: [{name: going, sets: [$0 == moving]}, {name: coming, causing: [@$0 == standing]}]}", {state});
  make_root(robot, "{providers: [{name: kicking, when: [$0 == standing]}, {name: stepping, tasks: [$1]}]}",
            {state, walk});
  if (defect) return;
  robot.add_root(walk, robot.below());
  make_root(robot, "{when: [$0 == standing]}", {state}); // that one steps where it could wait
}
void siblings_of_one_pack(Robot& robot, bool defect) {
  const std::string state = make_state(robot, "moving", "standing");
  const std::string waits = make(robot, "{when: [$0 == standing]}", {state});
  const std::string walk = make(
      robot, "{providers: [{name: going, sets: [$0 == moving]}, {name: coming, causing: [@$0 == standing]}]}", {state});
  make_root(robot,
            defect ? "{packs: {both: {$0: {priority: 20}, $1: {priority: 10, apart: true}}}}"
                   : "{packs: {both: {$0: {priority: 10, apart: true}, $1: {priority: 20}}}}",
            {walk, waits});
}

// push_held_by_outside

std::string make_sight(Robot& robot) {
  const std::string name = robot.name("Sight");
  robot.add_state(name, "{values: [dark, bright], initial: dark, external: true}");
  return name;
}

void the_skill_chooses(Robot& robot, bool defect) {
  const std::string state = make_state(robot, "moving", "standing"), sight = make_sight(robot);
  const std::string skill =
      make(robot, "{providers: [{name: looking, when: [$0 == bright]}, {name: feeling}]}", {sight});
  const std::string waits = make(
      robot, defect ? "{when: [@$0 == standing], needs: [$1], tasks: [$1]}" : "{when: [$0 == standing], tasks: [$1]}",
      {state, skill});
  ask_for_both(robot, waits, causer(robot, state, "standing", "moving"));
}
void the_task_chooses(Robot& robot, bool defect) {
  const std::string state = make_state(robot, "moving", "standing"), sight = make_sight(robot);
  const std::string waits =
      defect ? make(robot,
                    "{providers: [{name: seeing, when: [$0 == standing, $1 == bright]}, {name: seeking, when: [@$0 == "
                    "standing]}]}",
                    {state, sight})
             : make(robot, "{when: [$0 == standing]}", {state});
  ask_for_both(robot, waits, causer(robot, state, "standing", "moving"));
}
void the_company_chooses(Robot& robot, bool defect) {
  const std::string state = make_state(robot, "moving", "standing"), sight = make_sight(robot),
                    lamp = make(robot, "{}");
  const std::string looks =
      make(robot, "{providers: [{name: tracking, when: [$0 == bright]}, {name: lit, tasks: {$1: {optional: true}}}]}",
           {sight, lamp});
  const std::string waits = make(robot,
                                 defect ? "{when: [@$0 == standing], tasks: {$1: {optional: true}}}"
                                        : "{when: [$0 == standing], tasks: {$1: {optional: true}}}",
                                 {state, lamp});
  const std::string walks = causer(robot, state, "standing", "moving");
  make_root(robot,
            defect ? "{packs: {pick: {$0: {priority: 1}, $1: {}}}}"
                   : "{packs: {pick: {$0: {priority: 1}, $1: {apart: true}}}}",
            {waits, looks});
  robot.add_root(walks, robot.below());
}

// causer_not_running

/// Of its own: a root that leads to the causing group makes it the program's affair.
Pair new_pair(Robot& robot) {
  Pair out;
  out.part = robot.parts[robot.part()];
  out.state = make_state(robot, "moving", "standing");
  out.delicate = make(robot, "{when: [$0 == standing], needs: [$1], tasks: [$1]}", {out.state, out.part});
  out.resting = make(robot,
                     "{providers: [{name: going, needs: [$1], sets: [$0 == moving], tasks: [$1]}, "
                     "{name: halting, needs: [$1], causing: [$0 == standing], tasks: [$1]}]}",
                     {out.state, out.part});
  return out;
}
void alone_in_a_pack(Robot& robot, bool defect) {
  const Pair pair = new_pair(robot);
  make_root(robot,
            defect ? "{packs: {go: {$0: {priority: 20}, $1: {priority: 10, apart: true}}, shoot: {@$0: {}}}}"
                   : "{packs: {go: {@$0: {priority: 20}, $1: {priority: 10, apart: true}}}}",
            {pair.delicate, pair.resting});
}
void alone_further_down(Robot& robot, bool defect) {
  const Pair pair = new_pair(robot);
  const std::string shoot = make(robot, "{packs: {now: {@$0: {}}}}", {pair.delicate});
  make_root(robot,
            defect ? "{packs: {go: {$0: {priority: 20}, $1: {priority: 10, apart: true}}, alone: {$0: {}}}}"
                   : "{packs: {go: {$0: {priority: 20}, $1: {priority: 10, apart: true}}}}",
            {shoot, pair.resting});
}
void in_a_flat_list(Robot& robot, bool defect) {
  const Pair pair = new_pair(robot);
  make_root(robot,
            defect ? "{tasks: {@$0: {priority: 20}, $1: {priority: 10, apart: true}}}"
                   : "{packs: {go: {@$0: {priority: 20}, $1: {priority: 10, apart: true}}}}",
            {pair.delicate, pair.resting});
}

// imprecise_causing, unused_causing

void says_too_little(Robot& robot, bool defect) {
  const std::string state = robot.name("Bearing");
  robot.add_state(state, "{values: [moving, swaying, standing], initial: moving}");
  const std::string waits = make(robot, "{when: [$0 == standing]}", {state});
  const std::string walk =
      make(robot, "{providers: [{name: going, sets: [$0 == moving]}, {name: coming, causing: [@$0 $1]}]}",
           {state, defect ? robot.r.one_of({"> moving", "!= moving", "== swaying|standing"}) : "== standing"});
  ask_for_both(robot, waits, walk);
}
void promises_a_wide_range(Robot& robot, bool defect) {
  const std::string state = robot.name("Pressure");
  robot.add_state(state, "{range: [0, 100], initial: 0}");
  const std::string waits = make(robot, "{when: [$0 > 80]}", {state});
  const std::string pump =
      make(robot, "{providers: [{name: going, sets: [$0 == 0]}, {name: filling, causing: [@$0 $1]}]}",
           {state, defect ? "> 70" : "> 80"});
  ask_for_both(robot, waits, pump);
}
void for_what_needs_it(Robot& robot, bool defect) {
  const std::string state = robot.name("Pressure");
  robot.add_state(state, "{range: [0, 100], initial: 0}");
  const std::string torch = make(robot, "{when: [$0 > 80]}", {state});
  const std::string weld = make(robot, "{needs: [$0], tasks: [$0]}", {torch});
  const std::string held = make(robot, "{needs: [$0]}", {torch});
  const std::string pump =
      make(robot, "{providers: [{name: going, sets: [$0 == 0]}, {name: filling, causing: [@$0 $1]}]}",
           {state, defect ? "> 70" : "> 80"});
  ask_for_both(robot, robot.r.chance(0.5) ? weld : held, pump);
}
void nobody_waits(Robot& robot, bool defect) {
  const std::string state = make_state(robot, "loose", "tight");
  const std::string waits = make(robot, "{when: [$0 == tight]}", {state});
  const std::string causes =
      make(robot,
           defect ? "{providers: [{name: going, causing: [@$0 == loose]}, {name: coming, causing: [$0 == tight]}]}"
                  : "{providers: [{name: going, sets: [@$0 == loose]}, {name: coming, causing: [$0 == tight]}]}",
           {state});
  ask_for_both(robot, waits, causes);
}

// incompatible_pushes, push_cycle

void each_shuts_the_other_out(Robot& robot, bool defect) {
  const std::string arm = make_state(robot, "folded", "stretched"), head = make_state(robot, "low", "high");
  const std::string waits = make(robot, "{when: [$0 == stretched, @$1 == high]}", {arm, head});
  const std::string pose =
      make(robot,
           defect ? "{providers: [{name: going}, {name: stretching, when: [$1 == low], causing: [$0 == stretched]}, "
                    "{name: rising, when: [$0 == folded], causing: [$1 == high]}]}"
                  : "{providers: [{name: going}, {name: stretching, causing: [$0 == stretched]}, "
                    "{name: rising, causing: [$1 == high]}]}",
           {arm, head});
  ask_for_both(robot, waits, pose);
}
void for_what_it_needs(Robot& robot, bool defect) {
  const std::string gas = robot.name("Pressure");
  robot.add_state(gas, "{range: [0, 100], initial: 0}");
  const std::string door = make_state(robot, "open", "shut");
  const std::string torch = make(robot, "{when: [$0 > 50, @$1 == shut]}", {gas, door});
  const std::string weld = make(robot, "{needs: [$0], tasks: [$0]}", {torch});
  const std::string cell =
      make(robot,
           defect ? "{providers: [{name: going}, {name: filling, when: [$1 == open], causing: [$0 > 80]}, "
                    "{name: shutting, when: [$0 < 10], causing: [$1 == shut]}]}"
                  : "{providers: [{name: going}, {name: filling, causing: [$0 > 80]}, "
                    "{name: shutting, causing: [$1 == shut]}]}",
           {gas, door});
  ask_for_both(robot, weld, cell);
}
void three_in_a_pack(Robot& robot, const std::string& first, const std::string& second, const std::string& third) {
  if (robot.r.chance(0.5)) {
    robot.add_root(third, robot.above());
    robot.add_root(second, robot.above());
    robot.add_root(first, robot.above());
  } else {
    make_root(robot,
              "{packs: {go: {$0: {priority: 30}, $1: {priority: 20, apart: true}, $2: {priority: 10, apart: true}}}}",
              {first, second, third});
  }
}
void each_undoes_the_other(Robot& robot, bool defect) {
  const std::string lamp = make_state(robot, "dark", "lit"), battery = make_state(robot, "low", "full");
  const std::string film = make(robot, "{when: [$0 == lit, @$1 == full]}", {lamp, battery});
  const std::string light = make(
      robot, "{providers: [{name: going}, {name: shining, causing: [$0 == lit], sets: [$1 == low]}]}", {lamp, battery});
  const std::string power =
      make(robot,
           defect ? "{providers: [{name: going}, {name: charging, causing: [$1 == full, $0 == dark]}]}"
                  : "{providers: [{name: going}, {name: charging, causing: [$1 == full]}]}",
           {lamp, battery});
  three_in_a_pack(robot, film, light, power);
}
void cannot_run_after(Robot& robot, bool defect) {
  const std::string feet = make_state(robot, "moving", "standing"), arm = make_state(robot, "down", "up");
  const std::string cast = make(robot, "{when: [$0 == standing, @$1 == up]}", {feet, arm});
  const std::string walk = make(
      robot, "{providers: [{name: going, sets: [$0 == moving]}, {name: halting, causing: [$0 == standing]}]}", {feet});
  const std::string swing =
      make(robot,
           defect ? "{providers: [{name: going}, {name: lifting, when: [$0 == moving], causing: [$1 == up]}]}"
                  : "{providers: [{name: going}, {name: lifting, causing: [$1 == up]}]}",
           {feet, arm});
  three_in_a_pack(robot, cast, walk, swing);
}

// push_in_vain

void takes_the_request(Robot& robot, bool defect) {
  const std::string one = make_state(robot, "loose", "tight"), two = make_state(robot, "low", "high");
  const std::string waits = make(robot, "{when: [$0 == tight, @$1 == high]}", {one, two});
  const std::string child = make(robot, "{causing: [$0 == high]}", {two});
  const std::string k =
      make(robot,
           defect ? "{providers: [{name: going, packs: {play: {$1: {}}}}, {name: coming, causing: [$0 == tight]}]}"
                  : "{providers: [{name: going, packs: {play: {$1: {}}}}, {name: coming, causing: [$0 == tight], "
                    "packs: {hold_on: {$1: {}}}}]}",
           {one, child});
  ask_for_both(robot, waits, k);
}
void takes_the_group(Robot& robot, bool defect) {
  const std::string feet = make_state(robot, "moving", "standing"), arm = make_state(robot, "down", "up");
  const std::string hips = robot.add_part(), other = robot.add_part();
  const std::string torso = make(robot, "{needs: [$0]}", {defect ? hips : other});
  const std::string cast = make(robot, "{when: [@$0 == up, $1 == standing]}", {arm, feet});
  const std::string walk = make(
      robot,
      "{providers: [{name: going, sets: [$0 == moving]}, {name: halting, needs: [$1], causing: [$0 == standing]}]}",
      {feet, hips});
  const std::string swing =
      make(robot, "{providers: [{name: going}, {name: lifting, needs: [$1], causing: [$0 == up]}]}", {arm, torso});
  robot.add_root(swing, robot.above());
  robot.add_root(walk, robot.above());
  robot.add_root(cast, robot.above());
}
void takes_the_state(Robot& robot, bool defect) {
  const std::string door = make_state(robot, "shut", "open"), light = make_state(robot, "dark", "bright"),
                    power = make_state(robot, "up", "down");
  const std::string enter = make(robot, "{when: [$0 == open, @$1 == bright]}", {door, light});
  const std::string lock =
      make(robot,
           defect ? "{providers: [{name: going}, {name: opening, causing: [$0 == open], sets: [$1 == down]}]}"
                  : "{providers: [{name: going}, {name: opening, causing: [$0 == open]}]}",
           {door, power});
  const std::string lamp =
      make(robot, "{providers: [{name: going}, {name: shining, when: [$0 == up], causing: [$1 == bright]}]}",
           {power, light});
  three_in_a_pack(robot, enter, lock, lamp);
}
void kept_above(Robot& robot, bool defect) {
  const std::string state = make_state(robot, "loose", "tight"), hand = robot.add_part();
  const std::string waits = make(robot, "{when: [@$0 == tight]}", {state});
  const std::string k = make(
      robot,
      "{providers: [{name: going, packs: {hold_on: {$1: {}}}}, {name: coming, causing: [$0 == tight], needs: [$1]}]}",
      {state, hand});
  const std::string chief =
      make(robot, "{needs: [$0], packs: {ask: {$1: {}}}}", {defect ? hand : robot.add_part(), waits});
  robot.add_root(k, robot.above());
  robot.add_root(chief, robot.above());
}

// push_inversion

void somebody_between(Robot& robot, bool defect) {
  const std::string state = make_state(robot, "moving", "standing"), legs = robot.add_part();
  const std::string kick = make(robot, "{when: [$0 == standing]}", {state});
  const std::string dance = make(robot, "{needs: [$0]}", {legs});
  const std::string walk = make(
      robot,
      "{providers: [{name: going, sets: [$0 == moving]}, {name: halting, needs: [@$1], causing: [$0 == standing]}]}",
      {state, legs});
  const int low = robot.above(), middle = robot.above(), high = robot.above();
  robot.add_root(walk, defect ? low : middle);
  robot.add_root(dance, defect ? middle : low);
  robot.add_root(kick, high);
}
void something_below_between(Robot& robot, bool defect) {
  const std::string state = make_state(robot, "moving", "standing"), knees = robot.add_part();
  const std::string legs = make(robot, "{needs: [$0]}", {knees});
  const std::string stretch = make(robot, "{packs: {bend: {$0: {}}}}", {defect ? knees : robot.add_part()});
  const std::string kick = make(robot, "{when: [$0 == standing]}", {state});
  const std::string play =
      make(robot, "{packs: {shoot: {$0: {priority: 20}, $1: {priority: 10, apart: true}}}}", {kick, stretch});
  const std::string walk = make(
      robot,
      "{providers: [{name: going, sets: [$0 == moving]}, {name: halting, needs: [@$1], causing: [$0 == standing]}]}",
      {state, legs});
  robot.add_root(walk, robot.above());
  robot.add_root(play, robot.above());
}
void a_root_of_its_own(Robot& robot, bool defect) {
  const std::string state = make_state(robot, "moving", "standing"), legs = robot.add_part();
  const std::string kick = make(robot, "{when: [$0 == standing]}", {state});
  const std::string walk = make(
      robot,
      "{providers: [{name: going, sets: [$0 == moving]}, {name: halting, needs: [@$1], causing: [$0 == standing]}]}",
      {state, legs});
  const int lowest = robot.above();
  robot.add_root(walk, robot.above());
  robot.add_root(legs, defect ? robot.above() : lowest);
  robot.add_root(kick, robot.above());
}

// causer_goes_first

void the_wrong_way_round(Robot& robot, bool defect) {
  const std::string feet = make_state(robot, "moving", "standing");
  const std::string kick = make(robot, "{when: [$0 == standing]}", {feet});
  const std::string walk = causer(robot, feet, "standing", "moving");
  make_root(robot,
            defect ? "{packs: {shoot: {$0: {priority: 20, apart: true}, $1: {priority: 10}}, "
                     "pass: {@$0: {priority: 10, apart: true}, $1: {priority: 20}}}}"
                   : "{packs: {shoot: {$0: {priority: 20, apart: true}, $1: {priority: 10}}, "
                     "pass: {@$0: {priority: 20, apart: true}, $1: {priority: 10}}}}",
            {kick, walk});
}

constexpr Planter of_pushes[]{
    {"unreachable_causing", "nobody asks", nobody_asks},
    {"unreachable_causing", "never its turn", never_its_turn},
    {"unreachable_causing", "the lowest one", the_lowest_one},
    {"unreachable_causing", "only below itself", only_below_itself},
    {"unpushable_causing", "goes before", goes_before},
    {"unpushable_causing", "one unit", one_unit},
    {"unpushable_causing", "below the task", below_the_task},
    {"unpushable_causing", "siblings", siblings_of_one_pack},
    {"push_held_by_outside", "the skill chooses", the_skill_chooses},
    {"push_held_by_outside", "the task chooses", the_task_chooses},
    {"push_held_by_outside", "the company chooses", the_company_chooses},
    {"causer_not_running", "alone in a pack", alone_in_a_pack},
    {"causer_not_running", "further down", alone_further_down},
    {"causer_not_running", "a flat list", in_a_flat_list},
    {"imprecise_causing", "says too little", says_too_little},
    {"imprecise_causing", "a wide range", promises_a_wide_range},
    {"imprecise_causing", "for what needs it", for_what_needs_it},
    {"unused_causing", "nobody waits", nobody_waits},
    {"incompatible_pushes", "each shuts the other out", each_shuts_the_other_out},
    {"incompatible_pushes", "for what it needs", for_what_it_needs},
    {"push_cycle", "each undoes the other", each_undoes_the_other},
    {"push_cycle", "cannot run after", cannot_run_after},
    {"push_in_vain", "takes the request", takes_the_request},
    {"push_in_vain", "takes the group", takes_the_group},
    {"push_in_vain", "takes the state", takes_the_state},
    {"push_in_vain", "kept above", kept_above},
    {"push_inversion", "somebody between", somebody_between},
    {"push_inversion", "something below", something_below_between},
    {"push_inversion", "a root of its own", a_root_of_its_own},
    {"causer_goes_first", "in one of two packs", the_wrong_way_round},
};

} // namespace

std::span<const Planter> push_planters() { return of_pushes; }

} // namespace director::defects
