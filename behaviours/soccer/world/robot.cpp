// Header: behaviours/soccer/world/robot.hpp. Test: tests/behaviours/soccer/world/robot_test.cpp.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/world/robot.hpp"

#include <algorithm>
#include <cstdlib>

namespace sim {
namespace {

constexpr Angle full_speed = 500; // a tick: 500 degrees a second
constexpr Angle limit = 120 * degree;
constexpr Angle travel_of_a_step = 180 * degree; // all leg servos together, of both legs
constexpr int ticks_to_fall = 40;
constexpr Angle swing_through = -10 * degree; // a knee that comes by here is kicking
constexpr Angle pushed_up = 80 * degree, folded = 80 * degree, straight = 10 * degree;

constexpr std::size_t at(Servo servo) { return static_cast<std::size_t>(servo); }

} // namespace

Robot::Robot(Point place, Random& random)
    : random_(random),
      x_(std::int64_t{place.x} * 1000),
      y_(std::int64_t{place.y} * 1000),
      until_stumble_(random.between(400, 900)) {}

Milliseconds Robot::move(Servo servo, Angle to) {
  target_[at(servo)] = clamped(to, limit);
  const Angle way = std::abs(target_[at(servo)] - angle_[at(servo)]);
  return std::max(1, (way + servo_speed() - 1) / servo_speed()) * tick;
}

/// On the ground they have the robot's weight to move.
Angle Robot::servo_speed() const { return posture_ == Posture::upright ? full_speed : full_speed / 3; }

void Robot::release() {
  gait_ = false;
  stride_ = {};
}

void Robot::fall() {
  if (posture_ != Posture::upright) return;
  posture_ = Posture::falling;
  fallen_for_ = 0;
  sway_ = 0;
}

bool Robot::swings(soccer::Side leg) const {
  const std::size_t knee = at(leg == soccer::Side::left ? Servo::left_knee : Servo::right_knee);
  return !gait_ && posture_ == Posture::upright && before_[knee] > swing_through && angle_[knee] <= swing_through;
}

void Robot::step() {
  before_ = angle_;
  int moved = 0;
  for (std::size_t i = 0; i < servos; ++i) {
    angle_[i] += clamped(target_[i] - angle_[i], servo_speed());
    if (i < leg_servos) moved += std::abs(angle_[i] - before_[i]);
  }
  sway_ -= sway_ / 16;
  if (gait_ && posture_ == Posture::upright) walk(moved);
  balance();
}

void Robot::walk(int moved) {
  const std::int64_t ahead = std::int64_t{stride_.forward} * 1000 * moved / travel_of_a_step;
  const std::int64_t left = std::int64_t{stride_.left} * 1000 * moved / travel_of_a_step;
  const std::int64_t s = sine(heading_), c = cosine(heading_);
  x_ += (ahead * c - left * s) / one;
  y_ += (ahead * s + left * c) / one;
  heading_ = wrapped(heading_ + scaled(stride_.turn, moved, travel_of_a_step));
  sway_ += static_cast<int>(std::abs(ahead) + std::abs(left)) + scaled(std::abs(stride_.turn), moved, travel_of_a_step);
  if (sway_ > brisk_sway && --until_stumble_ <= 0) {
    until_stumble_ = random_.between(1200, 2200);
    fall();
  }
}

void Robot::balance() {
  const auto both = [&](Servo one_side, Servo other, auto holds) {
    return holds(angle_[at(one_side)]) && holds(angle_[at(other)]);
  };
  switch (posture_) {
  case Posture::upright: break;
  case Posture::falling:
    if (++fallen_for_ >= ticks_to_fall) posture_ = Posture::lying;
    break;
  case Posture::lying:
    if (both(Servo::left_arm, Servo::right_arm, [](Angle a) { return a >= pushed_up; }) &&
        both(Servo::left_knee, Servo::right_knee, [](Angle a) { return a >= folded; }))
      posture_ = Posture::kneeling;
    break;
  case Posture::kneeling:
    if (both(Servo::left_knee, Servo::right_knee, [](Angle a) { return a <= straight; })) posture_ = Posture::upright;
    break;
  }
}

} // namespace sim
