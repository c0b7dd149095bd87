// SPDX-License-Identifier: MIT
#include "behaviours/soccer/world/world.hpp"

#include <catch2/catch.hpp>

#include <vector>

using namespace sim;
using soccer::GamePhase;

namespace {

void pass(World& world, Milliseconds time) {
  for (Milliseconds t = 0; t < time; t += tick) world.step();
}

/// The senses and the pose of a robot that only walks ahead, as one list of numbers.
std::vector<int> stroll(std::uint64_t seed) {
  World world(seed);
  world.robot().engage();
  std::vector<int> seen;
  for (int i = 0; i < 6000; ++i) {
    if (i % 12 == 0) {
      const Angle swing = i % 24 == 0 ? 15 * degree : -15 * degree;
      world.robot().stride({40, 0, 2 * degree});
      world.robot().move(Servo::left_hip_yaw, swing);
      world.robot().move(Servo::right_hip_yaw, -swing);
    }
    world.step();
    const Pose pose = world.robot().pose();
    const Picture& picture = world.robot().picture();
    for (const int number : {pose.place.x, pose.place.y, pose.heading, world.ball().x, world.ball().y, picture.ball.x,
                             static_cast<int>(picture.seen), static_cast<int>(world.robot().posture())})
      seen.push_back(number);
  }
  return seen;
}

/// A robot that stands right behind the ball, after a walk there.
void walk_up_to_the_ball(World& world) {
  Robot& robot = world.robot();
  robot.engage();
  for (int i = 0; i < 2000; ++i) {
    const Pose pose = robot.pose();
    const Point way = turned(world.ball() - pose.place, -pose.heading);
    if (way.x < 200 && way.x > 0) break;
    const Angle swing = i % 2 == 0 ? 15 * degree : -15 * degree;
    robot.stride(
        {150, 0, clamped(bearing(way), 20 * degree)}); // too far for a robot, so that it is there before it stumbles
    robot.move(Servo::left_hip_yaw, swing);
    pass(world, robot.move(Servo::right_hip_yaw, -swing));
    REQUIRE(robot.posture() == Posture::upright);
  }
}

void kick_once(World& world) {
  pass(world, world.robot().move(Servo::right_knee, 60 * degree));
  pass(world, world.robot().move(Servo::right_knee, -30 * degree));
}

} // namespace

TEST_CASE("the same seed is the same world, another seed another one") {
  CHECK(stroll(1) == stroll(1));
  CHECK(stroll(1) != stroll(2));
}

TEST_CASE("the referee opens the game") {
  World world(1);
  CHECK(world.phase() == GamePhase::initial);
  pass(world, 1'000);
  CHECK(world.phase() == GamePhase::ready);
  pass(world, 7'000);
  CHECK(world.phase() == GamePhase::set);
  pass(world, 1'500);
  CHECK(world.phase() == GamePhase::playing);
}

TEST_CASE("a robot that stands still kicks the ball away") {
  World world(3);
  walk_up_to_the_ball(world);
  world.robot().release();
  pass(world, 1'000);
  REQUIRE(world.robot().still());
  const Point before = world.ball();
  kick_once(world);
  CHECK(world.kicks() == 1);
  pass(world, 1'000);
  CHECK(length(world.ball() - before) > 500);
  CHECK(world.robot().posture() == Posture::upright);
}

TEST_CASE("a robot that kicks while it still sways falls") {
  World world(3);
  walk_up_to_the_ball(world);
  world.robot().release();
  kick_once(world);
  CHECK(world.robot().posture() == Posture::falling);
  CHECK(world.kicks() == 0);
}

TEST_CASE("the camera sees what the head is turned to") {
  World world(1);
  const auto sees = [&world](Angle yaw) {
    world.robot().move(Servo::neck, yaw);
    pass(world, 600);
    return world.robot().picture().seen;
  };
  const Angle ball = bearing(world.ball() - world.robot().pose().place);
  CHECK(sees(ball));
  CHECK_FALSE(sees(ball + 60 * degree));
  CHECK(sees(ball - 20 * degree));
}
