// Header: tests/defects/planter.hpp. Test: itself.
// SPDX-License-Identifier: MIT
//
// What undoes a condition again.
#include "tests/defects/gadgets.hpp"
#include "tests/defects/planter.hpp"

namespace director::defects {

namespace {

// alternating_providers, self_defeating_handler, undone_by_stop, undone_by_expiry, undone_by_fallback,
// undone_by_itself, undone_in_turn

void start_shuts_itself_out(Robot& robot, bool defect) {
  const std::string grip = make_state(robot, "open", "closed");
  make_root(robot,
            defect ? "{when: [$0 == open], start: {sets: [@$0 == closed]}}"
                   : "{when: [$0 == open], stay: [$0 == open|closed], start: {sets: [@$0 == closed]}}",
            {grip});
}
void stop_lets_itself_in(Robot& robot, bool defect) {
  const std::string balance = robot.name("Balance");
  robot.add_state(balance, "{values: [fallen, standing], initial: standing, external: true}");
  make_root(robot, "{when: [$0 == standing], stop: {sets: [@$0 == $1]}, allow: [uncovered_state], because: it waits}",
            {balance, defect ? "standing" : "fallen"});
}
void stop_takes_it_back(Robot& robot, bool defect) {
  const std::string feet = robot.name("Feet"), legs = robot.add_part();
  robot.add_state(feet, "{values: [unknown, moving, standing], unordered: [unknown], initial: unknown}");
  const std::string kick =
      make(robot,
           defect ? "{when: [$0 == standing], needs: [$1], tasks: [$1]}"
                  : "{when: [$0 == standing], stay: [$0 == standing|unknown], needs: [$1], tasks: [$1]}",
           {feet, legs});
  const std::string walk = make(
      robot,
      "{stop: {sets: [@$0 == unknown]}, providers: [{name: going, needs: [$1], sets: [$0 == moving], tasks: [$1]}, "
      "{name: halting, needs: [$1], causing: [$0 == standing], tasks: [$1]}]}",
      {feet, legs});
  ask_for_both(robot, kick, walk);
}
void it_belongs_to_the_group(Robot& robot, bool defect) {
  const std::string feet = robot.name("Feet"), legs = robot.add_part(), walk = robot.verb();
  robot.add_state(feet, "{values: [far, near], initial: far, @of: $0}", {walk});
  robot.add_group(walk, "{needs: [$0], causing: [$1 == near]}", {legs, feet});
  const std::string kick = make(robot, "{needs: [$0]}", {legs});
  const std::string play = make(robot,
                                defect ? "{when: [$0 == near], packs: {shoot: {$1: {}}}}"
                                       : "{when: [$0 == near], stay: [$0 == near|far], packs: {shoot: {$1: {}}}}",
                                {feet, kick});
  ask_for_both(robot, play, walk);
}
void ends_what_requests_it(Robot& robot, bool defect) {
  const std::string seen = robot.name("Seen");
  robot.add_state(seen, "{values: [gone, ball, out], initial: gone, external: true}");
  const std::string search = make(robot, "{stop: {sets: [@$0 == gone]}, sets: [$0 == ball]}", {seen});
  make_root(robot,
            defect ? "{providers: [{name: searching, when: [$0 == gone], tasks: [$1]}, {name: resting}]}"
                   : "{providers: [{name: searching, when: [$0 == gone], stay: [$0 == gone|ball], tasks: [$1]}, "
                     "{name: resting}]}",
            {seen, search});
}
void nobody_renews_it(Robot& robot, bool defect) {
  const std::string pose = robot.name("Pose"), camera = robot.add_part();
  robot.add_state(pose, "{values: [stale, fresh], initial: stale, expires: {@after: 1 s, to: stale}}");
  const std::string grasp = make(robot,
                                 defect ? "{when: [$0 == fresh], needs: [$1], tasks: [$1]}"
                                        : "{when: [$0 == fresh], stay: [$0 == fresh|stale], needs: [$1], tasks: [$1]}",
                                 {pose, camera});
  ask_for_both(robot, grasp, make(robot, "{needs: [$1], causing: [$0 == fresh], tasks: [$1]}", {pose, camera}));
}
void falls_back_to_another(Robot& robot, bool defect) {
  const std::string base = make_state(robot, "rolling", "still"), arm = robot.add_part(), wheels = robot.add_part();
  const std::string pick = make(robot, "{when: [$0 == still], needs: [$1], tasks: [$1]}", {base, arm});
  const std::string rolling = "{name: rolling, needs: [$0], sets: [$1 == rolling], tasks: [$0]}";
  const std::string braking = defect ? "{name: braking, needs: [$0, @$2], causing: [$1 == still], tasks: [$0, $2]}"
                                     : "{name: braking, needs: [$0], causing: [$1 == still], tasks: [$0]}";
  ask_for_both(robot, pick, make(robot, "{providers: [" + rolling + ", " + braking + "]}", {wheels, base, arm}));
}
void unsettles_itself(Robot& robot, bool defect) {
  const std::string feet = make_state(robot, "moving", "standing");
  const std::string kick =
      make(robot,
           defect ? "{when: [$0 == standing], sets: [@$0 == moving]}"
                  : "{when: [$0 == standing], stay: [$0 == moving|standing], sets: [@$0 == moving]}",
           {feet});
  const std::string walk =
      make(robot, "{providers: [{name: going}, {name: halting, causing: [$0 == standing]}]}", {feet});
  ask_for_both(robot, kick, walk);
}
void unsettled_by_a_task(Robot& robot, bool defect) {
  const std::string feet = make_state(robot, "moving", "standing");
  const std::string leg = make(robot, "{sets: [@$0 == moving]}", {feet});
  const std::string kick = make(robot, "{packs: {swing: {$0: {}}}}", {leg});
  const std::string play =
      make(robot,
           defect ? "{when: [$0 == standing], packs: {shoot: {$1: {}}}}"
                  : "{when: [$0 == standing], stay: [$0 == moving|standing], packs: {shoot: {$1: {}}}}",
           {feet, kick});
  const std::string walk = causer(robot, feet, "standing", "moving");
  ask_for_both(robot, play, walk);
}

void takes_over_what_it_pushed(Robot& robot, bool defect) {
  const std::string at = make_state(robot, "folded", "ready");
  const std::string move = make(
      robot, "{providers: [{name: reaching, sets: [@$0 == folded]}, {name: readying, causing: [$0 == ready]}]}", {at});
  const std::string hand_over =
      make(robot,
           defect ? "{when: [$0 == ready], packs: {give: {$1: {}}}}"
                  : "{when: [$0 == ready], stay: [$0 == folded|ready], packs: {give: {$1: {}}}}",
           {at, move});
  ask_for_both(robot, hand_over, make(robot, "{packs: {go: {$0: {}}}}", {move}));
}

void unsettle_each_other(Robot& robot, bool defect) {
  const std::string base = make_state(robot, "rolling", "still"), arm = make_state(robot, "out", "folded");
  const std::string pick = make(robot,
                                defect ? "{when: [$0 == still], sets: [@$1 == out]}"
                                       : "{when: [$0 == still], stay: [$0 == still|rolling], sets: [@$1 == out]}",
                                {base, arm});
  const std::string drive = make(robot, "{when: [$0 == folded], sets: [@$1 == rolling]}", {arm, base});
  const auto causes = [&](const std::string& state, const std::string& value) {
    return make(robot, "{providers: [{name: going}, {name: coming, causing: [$0 == $1]}]}", {state, value});
  };
  ask_for_both(robot, pick, causes(base, "still"));
  ask_for_both(robot, drive, causes(arm, "folded"));
}

void bring_back_what_the_other_ends(Robot& robot, bool defect) {
  const std::string gait = make_state(robot, "standing", "trotting"), legs = robot.add_part();
  make_root(robot,
            defect ? "{providers: [{name: going, when: [$0 == standing], needs: [$1], sets: [@$0 == trotting], tasks: "
                     "[$1]}, {name: halting, needs: [$1], causing: [$0 == standing], tasks: [$1]}]}"
                   : "{providers: [{name: going, when: [$0 == standing], stay: [$0 == standing|trotting], needs: [$1], "
                     "sets: [@$0 == trotting], tasks: [$1]}, {name: halting, needs: [$1], causing: [$0 == standing], "
                     "tasks: [$1]}]}",
            {gait, legs});
}
void take_turns(Robot& robot, bool defect) {
  const std::string fork = make_state(robot, "low", "high");
  make_root(robot,
            defect ? "{providers: [{name: lifting, when: [$0 == low], sets: [@$0 == high]}, {name: lowering, sets: [$0 "
                     "== low]}]}"
                   : "{providers: [{name: lifting, when: [$0 == low], sets: [@$0 == high]}, {name: lowering, when: [$0 "
                     "== high], sets: [$0 == low]}]}",
            {fork});
}

constexpr Planter of_undoing[]{
    {"alternating_providers", "a push is meant", bring_back_what_the_other_ends},
    {"alternating_providers", "both by themselves", take_turns},
    {"self_defeating_handler", "start", start_shuts_itself_out},
    {"self_defeating_handler", "stop", stop_lets_itself_in},
    {"undone_by_stop", "its handler", stop_takes_it_back},
    {"undone_by_stop", "of the group", it_belongs_to_the_group},
    {"undone_by_stop", "what it sets itself", ends_what_requests_it},
    {"undone_by_expiry", "nobody renews it", nobody_renews_it},
    {"undone_by_fallback", "what it needs besides", falls_back_to_another},
    {"undone_by_itself", "the task", unsettles_itself},
    {"undone_by_itself", "a task below", unsettled_by_a_task},
    {"undone_by_itself", "the group that it pushed", takes_over_what_it_pushed},
    {"undone_in_turn", "two tasks", unsettle_each_other},
};

} // namespace

std::span<const Planter> undoing_planters() { return of_undoing; }

} // namespace director::defects
