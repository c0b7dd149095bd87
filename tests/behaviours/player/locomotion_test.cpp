// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/locomotion.hpp"
#include "runtime/hosted/trial.hpp"

#include <catch2/catch.hpp>

#include <chrono>

namespace {

using director::Outcome;
using director::Reason;
using director::testing::Fares;
using director::testing::Trial;
using soccer::LeftArm, soccer::LeftLeg, soccer::RightArm, soccer::RightLeg, soccer::Stability, soccer::Walk;
using namespace std::chrono_literals;
using Kind = Outcome::Kind;

struct Bench {
  sim::Random random{1};
  sim::Robot robot{{0, 0}, random};
  player::Locomotion locomotion{robot};
};

TEST_CASE("a step requests both legs, one to swing and one to carry, and the arms") {
  Bench bench;
  Trial<Walk::Walking> walking{{.stride = {.forward = 60}, .steps = 2}};
  const auto first = walking.run(bench.locomotion);
  CHECK(first.sets(Stability::unstable));
  CHECK(first.count() == 4);
  const sim::Angle swing = first.data<LeftLeg>().hip;
  CHECK(first.data<RightLeg>().hip == -swing);
  CHECK(first.data<LeftArm>().shoulder == -first.data<RightArm>().shoulder);
  const auto second = walking.reasons(Reason::subtask_done).run(bench.locomotion);
  CHECK(second.data<LeftLeg>().hip == -swing); // the other leg's turn
  CHECK(walking.reasons(Reason::subtask_done).run(bench.locomotion).outcome() == Kind::done);
}

TEST_CASE("a step that has begun is finished before the next one") {
  Bench bench;
  Trial<Walk::Walking> walking{{.stride = {.forward = 60}, .steps = 0}};
  walking.uses<LeftLeg>(Fares::done).uses<RightLeg>(Fares::running);
  CHECK(walking.run(bench.locomotion).outcome() == Kind::keep);
  walking.uses<RightLeg>(Fares::done);
  CHECK(walking.run(bench.locomotion).outcome() == Kind::pack);
}

TEST_CASE("to halt it puts its feet together, and reports that it stands once it is still") {
  Bench bench;
  Trial<Walk::Halting> halting{soccer::WalkCommand{}};
  const auto together = halting.reasons(Reason::pushed).run(bench.locomotion);
  CHECK(together.requests<LeftLeg>());
  CHECK(together.data<RightLeg>().knee == 0);
  CHECK(!together.sets<Stability>());
  CHECK(halting.uses<LeftLeg>(Fares::running).run(bench.locomotion).outcome() == Kind::keep);
  const auto still = halting.uses<LeftLeg>(Fares::done).run(bench.locomotion);
  CHECK(still.outcome() == Kind::keep);
  CHECK(still.sets(Stability::standing));
  CHECK(!still.wait());
}

TEST_CASE("while it sways, a halting robot looks again soon") {
  Bench bench;
  Trial<Walk::Start>{soccer::WalkCommand{}}.run(bench.locomotion);
  Trial<Walk::Walking>{soccer::WalkCommand{.stride = {.forward = 100}, .steps = 0}}.run(bench.locomotion);
  for (int i = 0; i < 40; ++i) { // a world in which the legs go back and forth
    bench.robot.move(sim::Servo::left_hip_yaw, i / 10 % 2 == 0 ? 15 * sim::degree : -15 * sim::degree);
    bench.robot.step();
  }
  REQUIRE(!bench.robot.still());
  Trial<Walk::Halting> halting{soccer::WalkCommand{}};
  halting.run(bench.locomotion);
  const auto answer = halting.run(bench.locomotion);
  CHECK(!answer.sets<Stability>());
  CHECK(answer.wait() == 50ms);
}

} // namespace
