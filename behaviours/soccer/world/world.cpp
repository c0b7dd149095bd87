// Header: behaviours/soccer/world/world.hpp. Test: tests/behaviours/soccer/world/world_test.cpp.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/world/world.hpp"

#include <cstdlib>

namespace sim {

using soccer::GamePhase;
using soccer::Side;

namespace {

constexpr int kick_speed = 15'000; // micrometres a tick: 1.5 m/s
constexpr int friction = 60;       // micrometres a tick, lost in each tick: 0.6 m/s^2
constexpr int body_radius = 110;
constexpr int foot_spacing = 120; // a foot meets a ball that is no further than this beside the robot's middle
constexpr Angle half_view = 35 * degree;
constexpr int farthest_seen = 4500;

/// In the robot's own frame: x ahead, y to its left.
Point as_seen_from(const Pose& pose, Point place) { return turned(place - pose.place, -pose.heading); }

} // namespace

World::World(std::uint64_t seed) : random_(seed), robot_({-2200, -900 + random_.between(-300, 300)}, random_) {
  enter(GamePhase::initial, 1'000);
  view_changes_ = random_.between(9'000, 14'000);
}

void World::step() {
  now_ += tick;
  robot_.step();
  meet();
  roll();
  whistle();
  if (new_picture()) look();
}

void World::meet() {
  const Pose pose = robot_.pose();
  const Point seen = as_seen_from(pose, ball());
  for (const Side leg : {Side::left, Side::right}) {
    if (!robot_.swings(leg)) continue;
    if (!robot_.still()) return robot_.fall();
    if (seen.x < 0 || seen.x > reach || std::abs(seen.y) > foot_spacing) continue;
    ++kicks_;
    ball_heading_ = wrapped(pose.heading + random_.between(-8 * degree, 8 * degree));
    ball_speed_ = kick_speed + random_.between(-2'000, 2'000);
  }
  const int distance = length(seen);
  if (robot_.posture() == Posture::upright && distance < body_radius) { // walked into: it rolls off the feet
    ball_heading_ = wrapped(pose.heading + bearing(seen));
    ball_speed_ = 3'000;
  }
}

void World::roll() {
  ball_x_ += std::int64_t{ball_speed_} * cosine(ball_heading_) / one;
  ball_y_ += std::int64_t{ball_speed_} * sine(ball_heading_) / one;
  ball_speed_ = ball_speed_ > friction ? ball_speed_ - friction : 0;
  const Point at = ball();
  if (std::abs(at.x) <= field_half.x && std::abs(at.y) <= field_half.y) return;
  if (at.x > field_half.x && std::abs(at.y) < goal_half) {
    ++goals_;
    kick_off();
  } else { // thrown in again, some way into the field
    place_ball({clamped(at.x, field_half.x - 900), clamped(at.y + random_.between(-300, 300), field_half.y - 600)});
  }
}

void World::whistle() {
  if (now_ < phase_ends_) return;
  switch (phase_) {
  case GamePhase::initial: enter(GamePhase::ready, 7'000); break;
  case GamePhase::ready:
    place_ball({0, 0});
    enter(GamePhase::set, 1'500);
    break;
  case GamePhase::set: enter(GamePhase::playing, 10 * 60'000); break;
  case GamePhase::playing: enter(GamePhase::finished, 60 * 60'000); break;
  case GamePhase::finished: break;
  }
}

void World::look() {
  if (now_ >= view_changes_) {
    hidden_ = !hidden_;
    view_changes_ = now_ + (hidden_ ? random_.between(1'500, 2'500) : random_.between(9'000, 16'000));
  }
  Picture picture = robot_.picture();
  picture.at = now_;
  const Point seen = as_seen_from(robot_.pose(), ball());
  const int distance = length(seen);
  const Angle off = wrapped(bearing(seen) - robot_.angle(Servo::neck));
  picture.seen =
      !hidden_ && robot_.posture() == Posture::upright && distance < farthest_seen && std::abs(off) < half_view;
  if (picture.seen) {
    const int blur = 5 + distance / 60;
    picture.ball = ball() + Point{random_.between(-blur, blur), random_.between(-blur, blur)};
  }
  robot_.see(picture);
}

void World::place_ball(Point place) {
  ball_x_ = std::int64_t{place.x} * 1000;
  ball_y_ = std::int64_t{place.y} * 1000;
  ball_speed_ = 0;
}

void World::kick_off() {
  place_ball({0, 0});
  enter(GamePhase::ready, 10'000);
}

void World::enter(GamePhase phase, Milliseconds lasts) {
  phase_ = phase;
  phase_ends_ = now_ + lasts;
}

} // namespace sim
