// SPDX-License-Identifier: MIT
#include "tests/compiler/stubs/behaviour.hpp"

#include <catch2/catch.hpp>

using namespace director::tests;
using director::compiler::stubs::to_text;

TEST_CASE("a class is wanted for each module, with a function for each provider and handler") {
  CHECK(to_text(wanted_of(walking_robot)) == R"(robot in robot.hpp
locomotion: team::robot::Locomotion, class Locomotion, files locomotion
  start team::robot::Walk::Start
    (robot.yaml:12)
  stop team::robot::Walk::Stop
    (robot.yaml:13)
    - sets: Motion == still
  provide team::robot::Walk::Walking
    Step after step. (robot.yaml:15)
    - when: Motion == moving
    - needs: Legs
    - triggers: Tick
    - tasks: Legs (optional)
  provide team::robot::Walk::Halting
    (robot.yaml:21)
    - needs: Legs
    - causing: Motion == still within 1500 ms
    - brake: Legs
    - rest: nothing
servos: team::robot::Servos, class Servos, files servos
  provide team::robot::Legs::Default
    (robot.yaml:27)
)");
}

TEST_CASE("no file is called like the generated header or the main file, and no class like the namespace") {
  CHECK(to_text(wanted_of("behaviour: robot\nlanguage: 1\ncpp: {namespace: Legs}\nroots: [A, B, C]\ngroups:\n"
                          "  A: {module: robot}\n  B: {module: main}\n  C: {module: legs}\n")) ==
        "robot in robot.hpp\n"
        "robot: Legs::Robot, class Robot, files robot_module\n"
        "  provide Legs::A::Default\n    (robot.yaml:6)\n"
        "main: Legs::Main, class Main, files main_module\n"
        "  provide Legs::B::Default\n    (robot.yaml:7)\n"
        "legs: Legs::Legs, class LegsModule, files legs\n"
        "  provide Legs::C::Default\n    (robot.yaml:8)\n");
}
