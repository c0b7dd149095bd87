// SPDX-License-Identifier: MIT
#include "behaviours/soccer/world/robot.hpp"

#include <catch2/catch.hpp>

using namespace sim;

namespace {

struct Bench {
  Random random{1};
  Robot robot{{0, 0}, random};
  int steps = 0;

  void pass(Milliseconds time) {
    for (Milliseconds t = 0; t < time; t += tick) robot.step();
  }

  /// Steps on alternating feet.
  void walk(int count) {
    for (const int end = steps + count; steps != end; ++steps) {
      const Angle swing = steps % 2 == 0 ? 15 * degree : -15 * degree;
      pass(robot.move(Servo::left_hip_yaw, swing));
      pass(robot.move(Servo::right_hip_yaw, -swing));
    }
  }
};

} // namespace

TEST_CASE("a servo arrives at the time that it announced") {
  Bench bench;
  const Milliseconds time = bench.robot.move(Servo::left_knee, 31 * degree);
  CHECK(time == 70);
  bench.pass(time - tick);
  CHECK(bench.robot.angle(Servo::left_knee) < 31 * degree);
  bench.pass(tick);
  CHECK(bench.robot.angle(Servo::left_knee) == 31 * degree);
  CHECK(bench.robot.move(Servo::left_knee, 31 * degree) == tick);
}

TEST_CASE("a servo stops at its limit") {
  Bench bench;
  bench.pass(bench.robot.move(Servo::neck, 900 * degree));
  CHECK(bench.robot.angle(Servo::neck) == 120 * degree);
}

TEST_CASE("legs that move are way only while the gait engine is engaged") {
  Bench bench;
  bench.robot.stride({60, 0, 0});
  bench.walk(10);
  CHECK(bench.robot.pose().place == Point{0, 0});
  bench.robot.engage();
  bench.robot.stride({60, 0, 0});
  bench.walk(10);
  CHECK(bench.robot.pose().place.x > 150);
  CHECK(bench.robot.pose().place.y == 0);
  CHECK_FALSE(bench.robot.still());
}

TEST_CASE("a robot that stops walking sways for a while, and then is still") {
  Bench bench;
  bench.robot.engage();
  bench.robot.stride({60, 0, 0});
  bench.walk(10);
  bench.robot.release();
  bench.pass(100);
  CHECK_FALSE(bench.robot.still());
  bench.pass(900);
  CHECK(bench.robot.still());
}

TEST_CASE("sooner or later a robot that walks stumbles") {
  Bench bench;
  bench.robot.engage();
  bench.robot.stride({60, 0, 0});
  while (bench.robot.posture() == Posture::upright && bench.steps < 1000) bench.walk(1);
  CHECK(bench.steps < 1000);
  bench.pass(500);
  CHECK(bench.robot.posture() == Posture::lying);
}

TEST_CASE("it gets up by tucking in, pushing up and straightening its knees, in this order") {
  Bench bench;
  bench.robot.fall();
  bench.pass(400);
  for (const Servo arm : {Servo::left_arm, Servo::right_arm}) bench.robot.move(arm, 90 * degree);
  bench.pass(500);
  CHECK(bench.robot.posture() == Posture::lying);
  for (const Servo knee : {Servo::left_knee, Servo::right_knee}) bench.robot.move(knee, 90 * degree);
  bench.pass(500);
  CHECK(bench.robot.posture() == Posture::kneeling);
  for (const Servo knee : {Servo::left_knee, Servo::right_knee}) bench.robot.move(knee, 0);
  bench.pass(500);
  CHECK(bench.robot.posture() == Posture::upright);
}
