// SPDX-License-Identifier: MIT
// What checks do not report, or report nevertheless, in shapes that would make their pages too long: each exemption has
// a limit, and each limit an exemption.
#include "tests/compiler/support/checked.hpp"

#include <catch2/catch.hpp>

#include <string>

namespace {

using namespace director;

/// `LINE: message [id]` for each finding, and its help.
std::string found(const std::string& text) {
  const tests::CheckedText checked = tests::check_text(text);
  std::string out;
  for (const dsl::Diagnostic& finding : checked.checked.findings) {
    const dsl::SourceFile& file = checked.sources[finding.span.file];
    out +=
        "\n" + std::to_string(file.place(finding.span.begin).line) + ": " + finding.message + " [" + finding.id + "]";
    if (!finding.help.empty()) out += "\n  " + finding.help;
  }
  return out + "\n";
}

/// What may differ between the robots of `fetching`: further states, and what `Fetch` requests.
struct Variation {
  std::string more_states{};
  std::string pack = R"(        Grasp: {priority: 30, apart: true}
        MoveArm: {priority: 20, apart: true}
        Nav: {priority: 10, apart: true}
)";
};

/// A robot that moves its arm to grasp, and may drive meanwhile. `rest`: the groups below `Fetch`.
std::string fetching(const std::string& rest, const Variation& variation = {}) {
  return R"(states:
  Base: {values: [moving, still], initial: still}
  Arm: {values: [away, ready], initial: away}
)" + variation.more_states +
         R"(roots: [Fetch]
groups:
  Fetch:
    packs:
      fetch:
)" + variation.pack +
         rest;
}

std::string fetching_by_ball(const std::string& rest) {
  return fetching(rest, {.more_states = "  Ball: {values: [near, far], initial: near, external: true}\n"});
}

const std::string move_arm = R"(  MoveArm:
    providers:
      - {name: hanging}
      - {name: reaching, when: [Base == still], causing: [Arm == ready]}
)";

const std::string nav = R"(  Nav:
    providers:
      - {name: going, sets: [Base == moving]}
      - {name: halting, causing: [Base == still]}
)";

const std::string brake = R"(  Brake:
    providers:
      - {name: released}
      - {name: braking, causing: [Base == still]}
)";

} // namespace

TEST_CASE(
    "push_in_vain: a step waits in vain though another one goes on by a `stay`, if that ends with another state too") {
  CHECK(found(R"(states:
  Bay: {values: [away, reached], initial: away, of: Load}
  Motion: {values: [moving, still], initial: moving}
roots: {Load: {priority: 18}, Photo: {priority: 15}, Tour: {priority: 10}}
groups:
  Load:
    providers:
      - {name: loading, when: [Bay == reached, Motion == still]}
      - {name: driving, when: [Bay == away], stay: [Bay == away|reached, Motion == moving], sets: [Bay == reached]}
  Photo: {when: [Motion == still]}
  Tour: {tasks: [Drive]}
  Drive:
    providers:
      - {name: rolling, sets: [Motion == moving]}
      - {name: halting, causing: [Motion == still]}
)") == R"(
10: `Load.loading` waits for `Motion == still` in vain: while `Load` waits, `Bay` is away again [push_in_vain]
  let `Load.loading` request a group that waits for `Motion == still` instead
)");
}

TEST_CASE("push_in_vain: several causing providers that nothing requests are told in the plural") {
  CHECK(found(R"(states:
  Estop: {values: [pressed, clear], initial: clear, external: true}
  Motion: {values: [still, rolling], initial: still}
roots: {Safety: {priority: 100}, Mission: {priority: 10}}
groups:
  Safety: {when: [Estop == pressed, Motion == still], allow: [uncovered_state], because: it waits for the button}
  Mission:
    providers:
      - {name: driving, when: [Estop == clear], packs: {go: {Drive: {}}}}
      - {name: idle}
  Drive:
    providers:
      - {name: rolling, sets: [Motion == rolling]}
      - {name: braking, needs: [Brake], causing: [Motion == still], tasks: [Brake]}
      - {name: coasting, causing: [Motion == still]}
  Brake: {}
)") == R"(
8: `Safety` waits for `Motion == still` in vain while `Estop` is pressed: `Drive.braking` and `Drive.coasting`, which could cause it, are not requested then [push_in_vain]
  let something request `Drive` that runs while `Estop` is pressed
17: `Drive.coasting` never runs: whenever `Drive` is requested, another provider comes first [shadowed_provider]
  let the others leave `Drive.coasting` something, or leave `Drive.coasting` out
)");
}

TEST_CASE("push_in_vain: what only the waiting task requests takes nothing from what that pushes") {
  CHECK(found(fetching(R"(  Grasp: {when: [Arm == ready], packs: {go: {Go: {}}}}
)" + move_arm + R"(  Go: {sets: [Base == moving]}
)" + brake,
                       {.pack = R"(        Grasp: {priority: 30, apart: true}
        MoveArm: {priority: 20, apart: true}
        Brake: {priority: 10, apart: true}
)"})) == R"(
23: `Brake.braking` never runs: whenever `Brake` is requested, another provider comes first [shadowed_provider]
  let the others leave `Brake.braking` something
)");
}

TEST_CASE("push_in_vain: another provider of the waiting task does not push for what the pushed one loses") {
  CHECK(found(fetching(R"(  Grasp:
    providers:
      - {name: grasping, when: [Arm == ready]}
      - {name: leaning, when: [Arm == ready, Base == still]}
  Look: {}
)" + move_arm + nav,
                       {.pack = R"(        Grasp: {priority: 30}
        Look: {priority: 25}
        MoveArm: {priority: 20, apart: true}
        Nav: {priority: 10, apart: true}
)"})) == R"(
12: `Look` is held back while `Grasp` waits for a condition, and shares nothing with it [waiting_company]
  make `Look` `apart`: it keeps its rank and goes on by itself
17: `Grasp.grasping` waits for `Arm == ready` in vain once `MoveArm.reaching`, which it pushes, has lost `Base == still`: the push is kept, and nothing is pushed for that condition [push_in_vain]
  let `Grasp.grasping` wait for `Base == still` too: then it pushes for that itself
18: `Grasp.leaning` never runs: `Grasp.grasping` comes before it and can run whenever it can [shadowed_provider]
  give `Grasp.grasping` a `when` that leaves something, or put this one before it
)");
}

TEST_CASE("push_in_vain: an optional task beside the waiting one may be left out, and pushes for nothing then") {
  CHECK(found(R"(states:
  Base: {values: [moving, still], initial: still}
  Arm: {values: [away, ready], initial: away}
roots: {Show: {priority: 20}, Fetch: {priority: 10}}
groups:
  Show: {packs: {show: {Photo: {priority: 25, apart: true}, Nav: {priority: 10, apart: true}}}}
  Fetch:
    packs:
      fetch:
        Grasp: {priority: 30, apart: true}
        Photo: {priority: 25, optional: true}
        MoveArm: {priority: 20, apart: true}
        Nav: {priority: 10, apart: true}
  Grasp: {when: [Arm == ready]}
  Photo: {when: [Base == still]}
)" + move_arm +
              nav) == R"(
13: `Photo` may wait here for `Base == still`, and pushes no group for it: `Nav` does not rank after `Photo` [causer_goes_first]
  make `Photo` `apart` instead of `optional`, with a higher priority than `Nav`
16: `Grasp` waits for `Arm == ready` in vain once `MoveArm.reaching`, which it pushes, has lost `Base == still`: the push is kept, and nothing is pushed for that condition [push_in_vain]
  let `Grasp` wait for `Base == still` too: then it pushes for that itself
)");
}

TEST_CASE("push_in_vain: a task that runs only without the condition does not want it kept") {
  CHECK(found(fetching(R"(  Grasp: {when: [Arm == ready, Base == moving]}
)" + move_arm + nav)) == R"(
14: no provider of `Grasp` can run while `Base` is still [uncovered_state]
  request `Grasp` only in providers that run while it can, followed by one without that request
18: `MoveArm.reaching` never runs: whenever `MoveArm` is requested, another provider comes first or a condition does not hold [shadowed_provider]
  let the others leave `MoveArm.reaching` something
)");
}

TEST_CASE("push_in_vain: what is granted only together with the waiting task does not run while that waits") {
  CHECK(found(fetching(R"(  Grasp: {when: [Arm == ready]}
  Go: {sets: [Base == moving]}
)" + move_arm + brake,
                       {.pack = R"(        Grasp: {priority: 30}
        Go: {priority: 25}
        MoveArm: {priority: 20, apart: true}
        Brake: {priority: 10, apart: true}
)"})) == R"(
12: `Go` is held back while `Grasp` waits for a condition, and shares nothing with it [waiting_company]
  make `Go` `apart`: it keeps its rank and goes on by itself
24: `Brake.braking` never runs: whenever `Brake` is requested, another provider comes first [shadowed_provider]
  let the others leave `Brake.braking` something
)");
}

TEST_CASE("push_in_vain: a state of the group that takes the condition does not begin again while that runs") {
  CHECK(found(R"(states:
  Base: {values: [moving, still], initial: still, of: Nav}
  Arm: {values: [away, ready], initial: away}
roots: [Fetch]
groups:
  Fetch:
    packs:
      fetch:
        Grasp: {priority: 30, apart: true}
        MoveArm: {priority: 20, apart: true}
        Nav: {priority: 10, apart: true}
  Grasp: {when: [Arm == ready]}
)" + move_arm +
              nav) == R"(
14: `Grasp` waits for `Arm == ready` in vain once `MoveArm.reaching`, which it pushes, has lost `Base == still`: the push is kept, and nothing is pushed for that condition [push_in_vain]
  let `Grasp` wait for `Base == still` too: then it pushes for that itself
)");
}

TEST_CASE("push_in_vain: a condition that a task and its need wait for is told once") {
  CHECK(found(fetching(R"(  Grasp: {when: [Arm == ready], needs: [Hand]}
  Hand: {when: [Arm == ready]}
)" + move_arm + nav)) == R"(
14: `Grasp` waits for `Arm == ready` in vain once `MoveArm.reaching`, which it pushes, has lost `Base == still`: the push is kept, and nothing is pushed for that condition [push_in_vain]
  let `Grasp` wait for `Base == still` too: then it pushes for that itself
)");
}

TEST_CASE("push_in_vain: another provider of the waiting task that takes the condition runs before, not then") {
  CHECK(found(fetching_by_ball(nav + R"(  Grasp:
    providers:
      - {name: grasping, when: [Arm == ready, Ball == near]}
      - {name: driving, when: [Ball == far], sets: [Base == moving]}
)" + move_arm)) == R"(
21: `Grasp.grasping` waits for `Arm == ready` in vain once `MoveArm.reaching`, which it pushes, has lost `Base == still`: the push is kept, and nothing is pushed for that condition [push_in_vain]
  let `Grasp.grasping` wait for `Base == still` too: then it pushes for that itself
)");
}

TEST_CASE("push_in_vain: a source of the waiting task itself does not hide another one that is declared later") {
  CHECK(found(fetching_by_ball(R"(  Grasp:
    providers:
      - {name: grasping, when: [Arm == ready, Ball == near]}
      - {name: driving, when: [Ball == far], sets: [Base == moving]}
)" + move_arm + nav)) == R"(
17: `Grasp.grasping` waits for `Arm == ready` in vain once `MoveArm.reaching`, which it pushes, has lost `Base == still`: the push is kept, and nothing is pushed for that condition [push_in_vain]
  let `Grasp.grasping` wait for `Base == still` too: then it pushes for that itself
)");
}

TEST_CASE("alternating_providers: two providers do not go round where one before them begins with the value too") {
  CHECK(found(R"(states:
  Fork: {values: [low, high], initial: low}
  Floor: {values: [level, steep], initial: level, external: true}
roots: [Lift]
groups:
  Lift:
    providers:
      - {name: resting, when: [Fork == low, Floor == steep]}
      - {name: lifting, when: [Fork == low], sets: [Fork == high]}
      - {name: lowering, sets: [Fork == low]}
)") == R"(
)");
}

TEST_CASE("undone_by_stop: a third group that runs only while nothing can be pushed does not stop for the task") {
  CHECK(found(R"(states:
  Stability: {values: [unstable, standing], initial: unstable}
  Ground: {values: [flat, rough], initial: flat, external: true}
roots: {Kick: {priority: 60}, Walk: {priority: 30}, Wave: {priority: 5}}
groups:
  Kick: {when: [Stability == standing], needs: [Arm], tasks: [Arm]}
  Walk:
    providers:
      - {name: walking}
      - {name: halting, when: [Ground == rough], causing: [Stability == standing]}
  Wave:
    when: [Ground == flat]
    needs: [Arm]
    tasks: [Arm]
    stop: {sets: [Stability == unstable]}
    allow: [uncovered_state]
    because: it waves on flat ground
  Arm: {}
)") == R"(
)");
}

TEST_CASE("undone_by_stop: of a group that is requested in two units no single request is to be `apart`") {
  CHECK(found(R"(states: {Knee: {values: [free, held], initial: free, of: Lock}}
roots: {Sit: {priority: 20}, Walk: {priority: 10}}
groups:
  Sit: {when: [Knee == held], needs: [Hip], tasks: [Hip]}
  Walk:
    packs:
      walk: {Step: {priority: 1}, Lock: {}}
      jog: {Step: {priority: 1}, Lock: {}}
  Step: {needs: [Hip], tasks: [Hip]}
  Hip: {}
  Lock:
    providers:
      - {name: idle}
      - {name: locking, causing: [Knee == held]}
)") == R"(
3: `Knee` is free again when `Lock` stops, and it is stopped when `Sit` is granted, which waits for `Knee == held`: the two go round [undone_by_stop]
  give `Sit` a `stay` under which `Knee` may be free
)");
}

TEST_CASE("undone_by_stop: a member counts where it is granted, though it is held as a need elsewhere") {
  CHECK(found(R"(states: {Base: {values: [still, rolling], initial: rolling}}
roots: {Grip: {priority: 30}, Work: {priority: 20}}
groups:
  Grip: {needs: [Hold], packs: {go: {Pick: {priority: 20}, Hold: {}}}}
  Work: {packs: {go: {Pick: {priority: 20}, Hold: {}, Tour: {priority: 10, apart: true}}}}
  Pick: {when: [Base == still], needs: [Hand], tasks: [Hand]}
  Hold: {needs: [Arm], tasks: [Arm]}
  Tour: {needs: [Arm], packs: {look: {Brake: {}, Arm: {}}}}
  Brake: {causing: [Base == still], stop: {sets: [Base == rolling]}}
  Arm: {}
  Hand: {}
)") == R"(
11: the stop of `Brake` may set `Base == rolling`, and it is stopped when `Hold` is granted together with `Pick`, which waits for `Base == still`: the two go round [undone_by_stop]
  give `Pick` a `stay` under which `Base` may be rolling
)");
}

TEST_CASE("undone_by_stop: a unit with a member that leads to the task is not blocked by it") {
  CHECK(found(R"(states: {Knee: {values: [free, held], initial: free, of: Lock}}
roots: {Sit: {priority: 20}, Walk: {priority: 10}}
groups:
  Sit: {when: [Knee == held], needs: [Hip], tasks: [Hip]}
  Walk: {packs: {walk: {Step: {priority: 1}, Turn: {}, Lock: {}}}}
  Step: {needs: [Hip], tasks: [Hip]}
  Turn: {tasks: [Sit]}
  Hip: {}
  Lock:
    providers:
      - {name: idle}
      - {name: locking, causing: [Knee == held]}
)") == R"(
7: `Step` takes `Hip` before anything below `Turn` is tried, which wants it too [sibling_starvation]
  make `Step` `optional`, or `apart` with a lower priority than `Turn`, or request it one level lower, by something with a lower priority than `Turn`
9: `Sit` may wait here for `Knee == held`, and pushes no group for it: `Lock` does not rank after `Turn` [causer_goes_first]
  give `Turn` a higher priority than `Lock`
)");
}

TEST_CASE("undone_by_expiry: the program may set an external state, beside another one that expires") {
  CHECK(found(R"(states:
  Light: {values: [dark, bright], initial: dark, external: true, expires: {after: 1 s, to: dark}}
  Pose: {values: [stale, fresh], initial: stale, expires: {after: 1 s, to: stale}}
roots: {Film: {priority: 20}, Shine: {priority: 10}, Look: {priority: 5}}
groups:
  Film: {when: [Light == bright], needs: [Arm], tasks: [Arm]}
  Shine: {needs: [Arm], causing: [Light == bright], tasks: [Arm], every: 100 ms}
  Look: {sets: [Pose], every: 100 ms}
  Arm: {}
)") == R"(
)");
}

TEST_CASE("undone_by_expiry: what is pushed has its time if that is as long as the state lasts") {
  CHECK(found(R"(states:
  Pose: {values: [stale, fresh], initial: stale, expires: {after: 5 s, to: stale}}
  Arm: {values: [out, ready], initial: out}
roots: {Grasp: {priority: 30}, MoveArm: {priority: 20}, Look: {priority: 10}}
groups:
  Grasp: {when: [Arm == ready], needs: [Hand], tasks: [Hand]}
  MoveArm:
    providers:
      - {name: resting, sets: [Arm == out]}
      - {name: reaching, when: [Pose == fresh], needs: [Camera], causing: [Arm == ready within 5 s], tasks: [Camera]}
  Look: {needs: [Camera], causing: [Pose == fresh within 3 s], tasks: [Camera], every: 100 ms}
  Hand: {}
  Camera: {}
)") == R"(
)");
}

TEST_CASE("undone_by_expiry: a provider whose condition fails on an unset state does not begin again") {
  CHECK(found(R"(states: {Pose: {values: [stale, fresh, lost], initial: stale, expires: 1 s}}
roots: {Grasp: {priority: 20}, Look: {priority: 10}}
groups:
  Grasp: {when: [Pose == fresh], needs: [Camera], tasks: [Camera]}
  Look: {when: [Pose != lost], needs: [Camera], causing: [Pose == fresh], tasks: [Camera]}
  Camera: {}
)") == R"(
7: no provider of `Look` can run while `Pose` is unset [uncovered_state]
  end with a provider that can always run, or allow this, if `Look` is requested only while it can run
7: `Pose != lost` is false while `Pose` is unset [unset_is_false]
  name the value that it expires to: `expires: {after: ..., to: ...}`
)");
}

TEST_CASE("undone_by_expiry: a condition that comes back as its own state expires is not lost") {
  CHECK(found(R"(states:
  Trim: {values: [moving, hovering], initial: hovering, expires: {after: 1 s, to: hovering}}
  Fix: {values: [drifting, good], initial: drifting, expires: {after: 5 s, to: drifting}}
roots: {Survey: {priority: 20}, Navigate: {priority: 5}}
groups:
  Survey: {when: [Fix == good], packs: {lane: {Swim: {}}}}
  Swim:
    needs: [Thrusters]
    sets: [Trim == moving]
    stop: {sets: [Trim == hovering]}
    tasks: [Thrusters]
  Navigate:
    providers:
      - {name: fixing, when: [Trim == hovering], needs: [Antenna], causing: [Fix == good], every: 1 s, tasks: [Antenna]}
      - {name: waiting}
  Thrusters: {}
  Antenna: {}
)") == R"(
)");
}

TEST_CASE("undone_by_expiry: what comes after a provider that can always run does not undo anything") {
  CHECK(found(R"(states:
  Base: {values: [still, rolling], initial: rolling, expires: {after: 1 s, to: rolling}}
roots: {Pick: {priority: 20}, Ride: {priority: 15}, Drive: {priority: 10}}
groups:
  Pick: {when: [Base == still], needs: [Arm], tasks: [Arm]}
  Ride: {when: [Base == rolling], needs: [Bell], tasks: [Bell]}
  Drive:
    providers:
      - {name: coasting}
      - {name: rolling, causing: [Base == rolling], needs: [Wheels], tasks: [Wheels]}
      - {name: braking, causing: [Base == still], needs: [Arm], tasks: [Arm]}
  Arm: {}
  Bell: {}
  Wheels: {}
)") == R"(
4: `Base` expires after 1 s, and `Drive.braking`, which could renew it, loses `Arm` when `Pick` is granted, which waits for `Base == still`: the two go round [undone_by_expiry]
  give `Pick` a `stay` under which `Base` may be rolling; or let `Pick` renew it while it runs
)");
}

TEST_CASE("undone_by_expiry: of a group that would renew it from two units no single request is to be `apart`") {
  CHECK(found(R"(states: {Knee: {values: [free, held], initial: free, expires: {after: 1 s, to: free}}}
roots: {Sit: {priority: 20}, Walk: {priority: 10}}
groups:
  Sit: {when: [Knee == held], needs: [Hip], tasks: [Hip]}
  Walk:
    packs:
      walk: {Step: {priority: 1}, Lock: {}}
      jog: {Step: {priority: 1}, Lock: {}}
  Step: {needs: [Hip], tasks: [Hip]}
  Hip: {}
  Lock:
    providers:
      - {name: idle}
      - {name: locking, every: 200 ms, causing: [Knee == held]}
)") == R"(
3: `Knee` expires after 1 s, and `Lock.locking`, which could renew it, stops when `Sit` is granted, which waits for `Knee == held`: the two go round [undone_by_expiry]
  give `Sit` a `stay` under which `Knee` may be free; or let `Sit` renew it while it runs
)");
}

TEST_CASE("waiting_company: a member with the lower rank keeps it when it is made `apart`") {
  CHECK(found(R"(states: {Water: {values: [cold, hot], initial: cold}}
roots: [Serve]
groups:
  Serve:
    packs:
      coffee: {Brew: {priority: 2}, Boiler: {priority: 1}}
      tea: {Brew: {priority: 2, apart: true}, Boiler: {priority: 1}}
  Brew: {when: [Water == hot]}
  Boiler:
    providers:
      - {name: resting, sets: [Water == cold]}
      - {name: heating, causing: [Water == hot]}
)") == R"(
8: `Boiler` is held back while `Brew` waits for a condition, and could bring it about [waiting_company]
  make `Boiler` `apart`: it keeps its rank and goes on by itself
13: `Boiler.resting` may set `Water == cold`, and then `Brew` is cut off until `Boiler.heating` causes `Water == hot` again [undone_by_itself]
  give `Brew` a `stay` under which `Water` may be cold
)");
}
