// SPDX-License-Identifier: MIT
#include "tests/compiler/cli/world.hpp"
#include "tests/compiler/support/rover_with_key.hpp"

#include <catch2/catch.hpp>

#include <utility>

namespace {

using director::tests::World;

World rover() {
  World world;
  world.files.add("rover.yaml", R"(behaviour: rover
language: 1
states:
  Motion: {values: [still, rolling], initial: still}
roots:
  Explore: {priority: 10}
  Photograph: {priority: 20}
  Dream: {priority: 1}
groups:
  Explore: {tasks: [Drive]}
  Photograph: {when: [Motion == still], needs: [Wheels], tasks: [Wheels]}
  Dream: {needs: [Wheels], tasks: [Wheels]}
  Drive:
    providers:
      - {name: rolling, needs: [Wheels], sets: [Motion == rolling], tasks: [Wheels]}
      - {name: braking, needs: [Wheels], causing: [Motion == still], tasks: [Wheels]}
  Wheels: {}
)");
  world.files.add("s.yaml", R"(scenario: a picture
behaviour: rover.yaml
script:
  Drive.rolling: {set: {Motion: rolling}, tasks: [Wheels]}
  Drive.braking:
    - {reason: wait, set: {Motion: still}, continue: true}
    - {wait: 1 s, tasks: [Wheels]}
steps:
  - request: Explore
  - disable: Drive.braking
  - request: Photograph
  - enable: Drive.braking
  - advance: 2 s
  - request: Dream
)");
  return world;
}

TEST_CASE("a group that only needs another one may not request it") {
  World world;
  world.files.add("head.yaml",
                  "behaviour: head\nlanguage: 1\nroots: [Look]\ngroups:\n  Look: {needs: [Servo]}\n  Servo: {}\n");
  world.files.add("s.yaml", "scenario: a look\nbehaviour: head.yaml\nsteps:\n  - advance: 1 s\n  - request: Look\n");
  CHECK(world.directorc({"why", "s.yaml", "Servo", "--step=1"}) == 0);
  CHECK(world.out == "nothing requests Servo\n  Look may need it, and does not run (head.yaml:5)\n");
  CHECK(world.directorc({"why", "s.yaml", "Servo"}) == 0);
  CHECK(world.out == "Servo is held for a need (Look>Servo), and is not requested\n  it is held for Look, priority 0, "
                     "that for the program, priority 0 (head.yaml:5)\n");
}

TEST_CASE("what happens at the time itself counts, and nothing after it") {
  World world = rover();
  world.files.add("at.yaml", "behaviour: rover.yaml\nsteps: [{advance: 1 s}, {request: Explore}, {advance: 1 s}, "
                             "{cancel: Explore}]\n");
  CHECK(world.directorc({"why", "at.yaml", "Explore", "--time=999 ms"}) == 0);
  CHECK(world.out == "nothing requests Explore\n  the program may (rover.yaml:6)\n");
  CHECK(world.directorc({"why", "at.yaml", "Explore", "--time=1 s"}) == 0);
  CHECK(world.out.starts_with("Explore runs"));
  CHECK(world.directorc({"why", "at.yaml", "Explore", "--time=1500 ms"}) == 0);
  CHECK(world.out.starts_with("Explore runs"));
  CHECK(world.directorc({"why", "at.yaml", "Explore", "--time=2 s"}) == 0);
  CHECK(world.out == "nothing requests Explore\n  the program may (rover.yaml:6)\n");
}

TEST_CASE("why a group runs, and for which requester") {
  World world = rover();
  CHECK(world.directorc({"why", "s.yaml", "Drive", "--step=1"}) == 0);
  CHECK(world.out == "Drive runs (Explore>Drive) in rolling\n"
                     "  it runs for Explore, priority 0, that for the program, priority 10 (rover.yaml:10)\n");
}

TEST_CASE("on a terminal the answer is highlighted, and so are the places") {
  World world = rover();
  world.colours = true;
  CHECK(world.directorc({"why", "s.yaml", "Drive", "--step=1"}) == 0);
  CHECK(world.out ==
        "\033[1mDrive runs (Explore>Drive) in rolling\033[0m\n"
        "  it runs for Explore, priority 0, that for the program, priority 10 (\033[36mrover.yaml:10\033[0m)\n");
}

TEST_CASE("why a group waits: which condition, and what the providers do that could cause it") {
  World world = rover();
  CHECK(world.directorc({"why", "s.yaml", "Photograph", "--step=3"}) == 0);
  CHECK(world.out == "Photograph waits (root>Photograph): until Motion == still, which no enabled provider promises\n"
                     "  Motion is rolling (rover.yaml:11)\n"
                     "  Drive.braking could cause it, and is disabled (rover.yaml:16)\n");
  CHECK(world.directorc({"why", "s.yaml", "Photograph", "--time", "500 ms"}) == 0);
  CHECK(world.out == "Photograph waits (root>Photograph): until Motion == still, which Drive.braking could cause\n"
                     "  Motion is rolling (rover.yaml:11)\n"
                     "  Drive.braking is to cause it: pushed for root>Photograph (rover.yaml:16)\n");
}

TEST_CASE("why a group waits: all conditions that are false, and which of them prevents a push") {
  World world;
  world.files.add("lift.yaml", R"(behaviour: lift
language: 1
states:
  Door: {values: [open, shut], initial: open}
  Load: {values: [none, light], initial: none}
roots: [Door_, Loader, Lift]
groups:
  Door_:
    providers: [{name: resting}, {name: closing, causing: [Door == shut]}]
  Loader: {sets: [Load == light]}
  Lift: {when: [Door == shut, Load == light]}
)");
  world.files.add("s.yaml", "behaviour: lift.yaml\nsteps: [{request: [Door_, Loader]}, {request: Lift}]\n");
  CHECK(world.directorc({"why", "s.yaml", "Lift"}) == 0);
  CHECK(world.out == "Lift waits (root>Lift): until Door == shut, which Door_.closing could cause\n"
                     "  Door is open (lift.yaml:11)\n"
                     "  Door_.closing could cause it, and is not pushed for root>Lift: Door_ is held by root>Door_, "
                     "which does not rank after it (lift.yaml:9)\n"
                     "  Load == light is false too, and no enabled provider promises it, so nothing is pushed "
                     "(lift.yaml:11)\n");
}

TEST_CASE("why a group waits: what could cause the condition waits for the outside") {
  World world;
  world.files.add("wind.yaml", R"(behaviour: wind
language: 1
states:
  Wind: {values: [calm, strong], initial: strong, external: true}
  Sail: {values: [furled, full], initial: furled}
roots: {SailTo: {priority: 10}, Rig: {priority: 1}}
groups:
  SailTo: {when: [Sail == full]}
  Rig: {providers: [{name: keeping}, {name: setting, when: [Wind == calm], causing: [Sail == full]}]}
)");
  world.files.add("s.yaml", "behaviour: wind.yaml\nsteps: [{request: [Rig, SailTo]}]\n");
  CHECK(world.directorc({"why", "s.yaml", "SailTo"}) == 0);
  CHECK(world.out == "SailTo waits (root>SailTo): until Sail == full, which Rig.setting could cause\n"
                     "  Sail is furled (wind.yaml:8)\n"
                     "  Rig.setting cannot cause it now: Wind == calm is false, and no enabled provider promises that "
                     "(wind.yaml:9)\n");
}

TEST_CASE("why a group waits: a condition of what it needs that prevents a push") {
  World world;
  world.files.add("near.yaml", R"(behaviour: near
language: 1
states:
  Arm: {values: [tucked, out], initial: out}
  Human: {values: [near, far], initial: near, external: true}
roots: {Travel: {priority: 20}, MoveArm: {priority: 5}}
groups:
  Travel: {when: [Arm == tucked], needs: [Drive]}
  Drive:
    providers: [{name: rolling, when: [Human == far], needs: [Wheels]}, {name: creeping, needs: [Wheels]}]
  MoveArm: {providers: [{name: reaching}, {name: tucking, causing: [Arm == tucked]}]}
  Wheels: {}
)");
  world.files.add("s.yaml", "behaviour: near.yaml\nsteps: [{request: [MoveArm, Travel]}, {set: {Human: far}}]\n");
  CHECK(world.directorc({"why", "s.yaml", "Travel", "--step=1"}) == 0);
  CHECK(world.out == "Travel waits (root>Travel): until Arm == tucked, which MoveArm.tucking could cause\n"
                     "  Arm is out (near.yaml:8)\n"
                     "  MoveArm.tucking could cause it, and is not pushed for root>Travel (near.yaml:11)\n"
                     "  Human == far of Drive.rolling, which Travel needs, is false too, and no enabled provider "
                     "promises it, so nothing is pushed (near.yaml:5)\n");
  CHECK(world.directorc({"why", "s.yaml", "Travel", "--step=2"}) == 0);
  CHECK(world.out == "Travel waits (root>Travel): until Arm == tucked, which MoveArm.tucking could cause\n"
                     "  Arm is out (near.yaml:8)\n"
                     "  MoveArm.tucking is to cause it: pushed for root>Travel (near.yaml:11)\n");
}

TEST_CASE("why a group waits: no condition of a disabled provider of what it needs") {
  World world;
  world.files.add("fetch.yaml", R"(behaviour: fetch
language: 1
states: {Lamp: {values: [dark, lit], initial: dark}, Door: {values: [shut, open], initial: shut}}
roots: [Fetch]
groups:
  Fetch: {when: [Lamp == lit], needs: [Arm]}
  Arm: {providers: [{name: reaching, when: [Door == open]}, {name: bending}]}
)");
  world.files.add("s.yaml", "behaviour: fetch.yaml\nsteps: [{disable: Arm.reaching}, {request: Fetch}]\n");
  CHECK(world.directorc({"why", "s.yaml", "Fetch"}) == 0);
  CHECK(world.out == "Fetch waits (root>Fetch): until Lamp == lit, which no enabled provider promises\n"
                     "  Lamp is dark (fetch.yaml:6)\n");
}

TEST_CASE("why a group runs in a provider that is not preferred") {
  World world;
  world.files.add("walk.yaml", R"(behaviour: walk
language: 1
states:
  Floor: {values: [dry, wet], initial: wet, external: true}
  Motion: {values: [moving, still], initial: moving}
roots: {Walk: {priority: 10}, Kick: {priority: 20}, Wave: {priority: 30}}
groups:
  Walk:
    providers:
      - {name: leaping}
      - {name: running, when: [Floor == dry]}
      - {name: swinging, needs: [Arms]}
      - {name: creeping}
      - {name: halting, causing: [Motion == still]}
  Kick: {when: [Motion == still]}
  Wave: {needs: [Arms], tasks: [Arms]}
  Arms: {}
)");
  world.files.add("s.yaml", "behaviour: walk.yaml\nsteps: [{disable: Walk.leaping}, {request: [Wave, Walk]}, {request: "
                            "Kick}]\n");
  CHECK(world.directorc({"why", "s.yaml", "Walk", "--step=2"}) == 0);
  CHECK(world.out == "Walk runs (root>Walk) in creeping\n"
                     "  it runs for the program, priority 10 (walk.yaml:6)\n"
                     "  Walk.leaping is preferred, but is disabled (walk.yaml:10)\n"
                     "  Walk.running is preferred, but Floor == dry is false: Floor is wet (walk.yaml:11)\n"
                     "  Walk.swinging is preferred, but Arms is held by Wave>Arms (walk.yaml:12)\n");
  CHECK(world.directorc({"why", "s.yaml", "Walk", "--step=3"}) == 0);
  CHECK(world.out == "Walk runs (root>Walk) in halting\n"
                     "  it runs for the program, priority 10 (walk.yaml:6)\n"
                     "  Walk.halting is pushed for root>Kick (walk.yaml:14)\n");
}

TEST_CASE("why a group runs in a provider that is not preferred: of many others the first eight") {
  World world;
  std::string providers, expected = "Walk runs (root>Walk) in last\n"
                                    "  it runs for the program, priority 0 (walk.yaml:4)\n";
  for (int i = 1; i <= 9; ++i) {
    const std::string number = std::to_string(i);
    providers += "      - {name: p" + number + ", when: [Floor == " + number + "]}\n";
    if (i > 8) continue;
    expected += "  Walk.p" + number + " is preferred, but Floor == " + number +
                " is false: Floor is 0 (walk.yaml:" + std::to_string(i + 7) + ")\n";
  }
  world.files.add("walk.yaml", "behaviour: walk\nlanguage: 1\nstates: {Floor: {range: [0, 9], initial: 0, external: "
                               "true}}\nroots: [Walk]\ngroups:\n  Walk:\n    providers:\n" +
                                   providers + "      - {name: last}\n");
  world.files.add("s.yaml", "behaviour: walk.yaml\nsteps: [{request: Walk}]\n");
  CHECK(world.directorc({"why", "s.yaml", "Walk"}) == 0);
  CHECK(world.out == expected);
}

TEST_CASE("why a group runs in the provider of a push that has no effect on it") {
  World world;
  world.files.add("rover.yaml", director::tests::rover_with_key);
  world.files.add("s.yaml", "behaviour: rover.yaml\nscript: {Drive: {continue: true}}\n"
                            "steps: [{request: [Low, Photo]}, {request: High}, {set: {Key: off}}]\n");
  CHECK(world.directorc({"why", "s.yaml", "Drive"}) == 0);
  CHECK(world.out == "Drive runs (High>Drive) in braking\n"
                     "  it runs for High, priority 0, that for the program, priority 30 (rover.yaml:9)\n"
                     "  Drive.rolling is preferred, but Key == on is false: Key is off (rover.yaml:12)\n");
}

TEST_CASE("why a group that waits for a condition of one provider does not run in another one") {
  World world;
  world.files.add("play.yaml", R"(behaviour: play
language: 1
states:
  Ball: {values: [far, near], initial: far, external: true}
  Light: {values: [red, green], initial: red, external: true}
roots: {Play: {priority: 20}, Dance: {priority: 30}}
groups:
  Play:
    providers:
      - {name: shooting, when: [Ball == near]}
      - {name: searching, when: [Light == green], needs: [Head]}
  Dance: {needs: [Head], tasks: [Head]}
  Head: {}
)");
  world.files.add("s.yaml", "behaviour: play.yaml\nsteps: [{request: [Dance, Play]}, {set: {Light: green}}]\n");
  const std::string head = "Play waits (root>Play): until Ball == near, which no enabled provider promises\n"
                           "  Ball is far (play.yaml:10)\n"
                           "  the outside may set Ball (play.yaml:4)\n";
  CHECK(world.directorc({"why", "s.yaml", "Play", "--step=1"}) == 0);
  CHECK(world.out ==
        head + "  Play.searching would do too, but Light == green is false: Light is red (play.yaml:11)\n");
  CHECK(world.directorc({"why", "s.yaml", "Play", "--step=2"}) == 0);
  CHECK(world.out == head + "  Play.searching would do too, but Head is held by Dance>Head (play.yaml:11)\n");
}

TEST_CASE("why a group waits: a push that stands keeps others from being pushed, also while its provider cannot run") {
  World world;
  const std::string lift = R"(behaviour: lift
language: 1
states:
  Door: {values: [open, shut], initial: open}
  Power: {values: [on, off], initial: on, external: true}
roots: {Lift: {priority: 5}, Motor: {priority: 1}, Helper: {priority: 1}}
groups:
  Lift: {when: [Door == shut]}
  Motor: {providers: [{name: closing, when: [Power == on], causing: [Door == shut]}, {name: resting}]}
  Helper: {providers: [{name: resting}, {name: pulling, causing: [Door == shut]}]}
)";
  world.files.add("lift.yaml", lift);
  const auto why = [&](const std::string& last) {
    world.files.add("s.yaml", "behaviour: lift.yaml\nsteps: [request: [Motor, Helper, Lift], " + last + "]\n");
    CHECK(world.directorc({"why", "s.yaml", "Lift"}) == 0);
    return std::exchange(world.out, {});
  };
  const auto head = [](const std::string& first) {
    return "Lift waits (root>Lift): until Door == shut, which " + first +
           " could cause\n"
           "  Door is open (lift.yaml:8)\n";
  };
  const std::string other =
      "  Helper.pulling could cause it, and is not pushed for root>Lift, because Motor.closing is "
      "(lift.yaml:10)\n";
  CHECK(why("set: {Power: off}") ==
        head("Motor.closing") +
            "  Motor.closing is pushed for root>Lift, and cannot run now: Power == on is false: Power is off "
            "(lift.yaml:9)\n" +
            other);
  const std::string_view condition = "when: [Power == on], causing";
  std::string below = lift;
  below.replace(below.find(condition), condition.size(), "needs: [Fuse], causing");
  world.files.add("lift.yaml", below + "  Fuse: {when: [Power == on]}\n");
  CHECK(why("set: {Power: off}") == head("Motor.closing") +
                                        "  Motor.closing is pushed for root>Lift, and cannot run now: Fuse, which it "
                                        "needs, cannot run: Power == on is "
                                        "false: Power is off (lift.yaml:9)\n" +
                                        other);
  world.files.add("lift.yaml", lift);
  CHECK(why("disable: Motor.closing") ==
        head("Helper.pulling") + "  Motor.closing is pushed for root>Lift, and is disabled (lift.yaml:9)\n" + other);
}

TEST_CASE("why a group waits: a holder that does not rank after the task is not pushed for it") {
  World world;
  const auto why = [&](const std::string& roots, const std::string& request) {
    world.files.add("anchor.yaml", "behaviour: anchor\nlanguage: 1\n"
                                   "states: {Sail: {values: [full, furled], initial: full}}\n"
                                   "roots: " +
                                       roots +
                                       "\ngroups:\n"
                                       "  Harbour: {packs: {anchor: {Anchor: {apart: true}, Rig: {apart: true}}}}\n"
                                       "  Anchor: {when: [Sail == furled]}\n"
                                       "  Rig: {providers: [{name: keeping}, {name: furling, causing: [Sail == "
                                       "furled]}]}\n");
    world.files.add("s.yaml", "behaviour: anchor.yaml\nsteps: [request: " + request + "]\n");
    CHECK(world.directorc({"why", "s.yaml", "Anchor"}) == 0);
    return std::exchange(world.out, {});
  };
  const std::string head = "Anchor waits (Harbour>Anchor): until Sail == furled, which Rig.furling could cause\n"
                           "  Sail is full (anchor.yaml:7)\n",
                    holder = "Rig is held by Harbour>Rig, which does not rank after it (anchor.yaml:8)\n";
  CHECK(why("[Harbour]", "Harbour") ==
        head + "  Rig.furling could cause it, and is not pushed for Harbour>Anchor: " + holder);
  CHECK(why("{Harbour: {priority: 60}, Rig: {priority: 1}}", "[Rig, Harbour]") ==
        head + "  Rig.furling is pushed for Harbour>Anchor, without effect: " + holder);
}

TEST_CASE("why a group waits: which tasks hold what it needs") {
  World world = rover();
  CHECK(world.directorc({"why", "s.yaml", "Dream"}) == 0);
  CHECK(world.out ==
        "Dream waits (root>Dream): Wheels, which it needs, is held by Photograph>Wheels, and root>Photograph "
        "(priority 20) goes before root>Dream (priority 1)\n"
        "  it is held for Photograph, priority 0, that for the program, priority 20 (rover.yaml:11)\n");
  CHECK(world.directorc({"why", "s.yaml", "Dream", "--format=json"}) == 0);
  CHECK(world.out ==
        "{\"group\":\"Dream\",\"kind\":\"need_held\",\"text\":\"Dream waits (root>Dream): Wheels, which it "
        "needs, is held by Photograph>Wheels, and root>Photograph (priority 20) goes before root>Dream "
        "(priority 1)\",\"notes\":[{\"text\":\"it is held for Photograph, priority 0, that for the program, "
        "priority 20\",\"place\":\"rover.yaml:11\"}]}\n");
}

TEST_CASE("why a group waits: its requester keeps what it needs itself") {
  World world;
  world.files.add("kick.yaml", R"(behaviour: kick
language: 1
roots: [KickTo]
groups:
  KickTo: {needs: [Legs], tasks: {Walk: {priority: 20, apart: true}, Legs: {priority: 10}}}
  Walk: {needs: [Legs]}
  Legs: {}
)");
  world.files.add("s.yaml", "behaviour: kick.yaml\nsteps: [{request: KickTo}]\n");
  CHECK(world.directorc({"why", "s.yaml", "Walk"}) == 0);
  CHECK(world.out == "Walk waits (KickTo>Walk): Legs, which it needs, is held by KickTo>Legs, which KickTo needs "
                     "itself\n"
                     "  it is held for KickTo, priority 10, that for the program, priority 0 (kick.yaml:5)\n");
}

const char* const boss = R"(behaviour: boss
language: 1
states: {Power: {values: [low, fine], initial: fine, external: true}}
roots: [Boss]
groups:
  Boss:
    providers:
      - {name: saving, when: [Power == low], needs: [Arm], tasks: {Walk: {priority: 1}}}
      - name: normal
        needs: [Arm]
        packs:
          slow: {Walk: {priority: 5, optional: true}}
          fast:
            Walk: {priority: 5}
            Look: {priority: 3}
          far:
            Look: {priority: 3}
            Walk: {levels: {slowly: {priority: 5}, quickly: {priority: 7}}}
  Walk: {needs: [Legs], tasks: [Legs]}
  Look: {}
  Legs: {}
  Arm: {}
)";

TEST_CASE("the place of a request is that of the active provider and of its pack") {
  World world;
  world.files.add("boss.yaml", boss);
  const auto place = [&](const std::string& pack, const std::string& group) {
    world.files.add("s.yaml",
                    "behaviour: boss.yaml\nscript:\n  Boss.normal: {pack: " + pack + "}\nsteps: [{request: Boss}]\n");
    CHECK(world.directorc({"why", "s.yaml", group}) == 0);
    return world.out.substr(world.out.find('\n') + 1);
  };
  CHECK(place("slow", "Walk") == "  it runs for Boss, priority 5, that for the program, priority 0 (boss.yaml:12)\n");
  CHECK(place("fast", "Walk") == "  it runs for Boss, priority 5, that for the program, priority 0 (boss.yaml:14)\n");
  CHECK(place("far, with: [Walk: {level: quickly}]", "Walk") ==
        "  it runs for Boss, priority 7, that for the program, priority 0 (boss.yaml:18)\n");
  CHECK(place("fast", "Arm") == "  it is held for Boss, priority 0, that for the program, priority 0 (boss.yaml:10)\n");
}

TEST_CASE("why a group waits: another task of its unit needs the same") {
  World world;
  world.files.add("boss.yaml", R"(behaviour: boss
language: 1
roots: [Boss]
groups:
  Boss:
    tasks:
      Walk: {}
      Kick: {}
      Look: {}
  Walk: {needs: [Legs], tasks: [Legs]}
  Kick: {needs: [Legs], tasks: [Legs]}
  Look: {}
  Legs: {needs: [Hips]}
  Hips: {}
)");
  world.files.add("s.yaml", "behaviour: boss.yaml\nsteps: [{request: Boss}]\n");
  CHECK(world.directorc({"why", "s.yaml", "Walk"}) == 0);
  CHECK(world.out == "Walk waits (Boss>Walk): it and the other tasks of its unit cannot all be granted\n"
                     "  Boss requests Walk, Kick and Look as one unit, which is granted as a whole or waits "
                     "(boss.yaml:7)\n"
                     "  Walk and Kick each need Legs (boss.yaml:8)\n");
}

TEST_CASE("why a group waits: what is enabled of another task of its unit needs the same") {
  World world;
  world.files.add("boss.yaml", R"(behaviour: boss
language: 1
roots: [Boss]
groups:
  Boss: {packs: {go: [Lift, Wave]}}
  Lift: {providers: [{name: with_arms, needs: [Arms]}, {name: with_back}]}
  Wave: {needs: [Arms]}
  Arms: {}
)");
  world.files.add("s.yaml", "behaviour: boss.yaml\nsteps: [{disable: Lift.with_back}, {request: Boss}]\n");
  CHECK(world.directorc({"why", "s.yaml", "Lift"}) == 0);
  CHECK(world.out == "Lift waits (Boss>Lift): it and the other tasks of its unit cannot all be granted\n"
                     "  Boss requests Lift and Wave as one unit, which is granted as a whole or waits (boss.yaml:5)\n"
                     "  Lift and Wave each need Arms (boss.yaml:5)\n");
}

TEST_CASE("why a group waits: it needs another task of its unit") {
  World world;
  world.files.add("boss.yaml", R"(behaviour: boss
language: 1
roots: [Boss]
groups:
  Boss:
    tasks:
      Walk: {}
      Legs: {}
  Walk: {needs: [Legs]}
  Legs: {}
)");
  world.files.add("s.yaml", "behaviour: boss.yaml\nsteps: [{request: Boss}]\n");
  CHECK(world.directorc({"why", "s.yaml", "Legs"}) == 0);
  CHECK(world.out == "Legs waits (Boss>Legs): it and the other tasks of its unit cannot all be granted\n"
                     "  Boss requests Walk and Legs as one unit, which is granted as a whole or waits (boss.yaml:8)\n"
                     "  Walk needs Legs, which is another task of the unit (boss.yaml:7)\n");
}

TEST_CASE("why a group waits: too little is enabled to meet all its needs") {
  World world;
  world.files.add("carrier.yaml", R"(behaviour: carrier
language: 1
roots: [Carry]
groups:
  Carry: {needs: [Lift, Arm]}
  Lift:
    providers:
      - {name: fork, needs: [Fork]}
      - {name: arm, needs: [Arm]}
  Fork: {}
  Arm: {}
)");
  world.files.add("s.yaml", "behaviour: carrier.yaml\nsteps: [{disable: Lift.fork}, {request: Carry}]\n");
  CHECK(world.directorc({"why", "s.yaml", "Carry"}) == 0);
  CHECK(world.out == "Carry waits (root>Carry): with what is disabled, what it takes cannot be had together\n"
                     "  Lift.fork is disabled (carrier.yaml:8)\n");
}

TEST_CASE("why a group does not run that nothing requests") {
  World world = rover();
  CHECK(world.directorc({"why", "s.yaml", "Drive", "--step=6"}) == 0);
  CHECK(world.directorc({"why", "s.yaml", "Dream", "--step=5"}) == 0);
  CHECK(world.out == "nothing requests Dream\n  the program may (rover.yaml:8)\n");
}

TEST_CASE("a question that cannot be answered is wrong usage") {
  World world = rover();
  CHECK(world.directorc({"why", "s.yaml", "Drvie"}) == 2);
  CHECK(world.err == "directorc: there is no group called `Drvie`; did you mean `Drive`?\n");
  CHECK(world.directorc({"why", "s.yaml", "Drive", "--step=7"}) == 2);
  CHECK(world.err == "directorc: `s.yaml` has 6 steps\n");
  world.files.add("short.yaml", "behaviour: rover.yaml\nsteps: [{request: Explore}]\n");
  CHECK(world.directorc({"why", "short.yaml", "Drive", "--step=2"}) == 2);
  CHECK(world.err == "directorc: `short.yaml` has 1 step\n");
  CHECK(world.directorc({"why", "s.yaml", "Drive", "--time=1 min"}) == 2);
  CHECK(world.err == "directorc: `s.yaml` ends at 2 s, before 60 s\n");
  CHECK(world.directorc({"why", "s.yaml", "Drive", "--time=soon"}) == 2);
  CHECK(world.err == "directorc: `soon` is no time: a whole number and us, ms, s or min\n");
  CHECK(world.directorc({"why", "s.yaml", "Drive", "--time=9999999999999 s"}) == 2);
  CHECK(world.err == "directorc: `9999999999999 s` is too long: at most 999999999999 s\n");
  CHECK(world.directorc({"why", "none.yaml", "Drive"}) == 2);
}

} // namespace
