#pragma once
// SPDX-License-Identifier: MIT
// Shape: a soccer field with one robot, one ball, a referee and passers-by who stand in the way of the camera;
// everything that happens follows from the seed and from what the robot is told to do. Units: geometry.hpp; the field's
// origin is its centre, the goal is at +x. Errors: none.

#include "behaviours/soccer/world/robot.hpp"

namespace sim {

inline constexpr Point field_half{3000, 2000};
inline constexpr int goal_half = 700;
inline constexpr Point goal{field_half.x, 0};
inline constexpr Point kick_off_place{-900, 0};
inline constexpr int reach = 250; ///< how far ahead of the robot a kick meets the ball

class World {
public:
  explicit World(std::uint64_t seed);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  void step(); ///< one tick
  Milliseconds now() const { return now_; }
  Robot& robot() { return robot_; }
  const Robot& robot() const { return robot_; }
  Point ball() const { return {static_cast<int>(ball_x_ / 1000), static_cast<int>(ball_y_ / 1000)}; }
  soccer::GamePhase phase() const { return phase_; }
  bool new_picture() const { return now_ % picture_every == 0; } ///< in this tick
  int goals() const { return goals_; }
  int kicks() const { return kicks_; } ///< that met the ball

private:
  static constexpr Milliseconds picture_every = 100;

  void roll();
  void meet(); ///< of robot and ball
  void whistle();
  void look();
  void place_ball(Point place);
  void kick_off();
  void enter(soccer::GamePhase phase, Milliseconds lasts);

  Random random_;
  Robot robot_;
  Milliseconds now_ = 0, phase_ends_ = 0, view_changes_ = 0;
  std::int64_t ball_x_ = 0, ball_y_ = 0; ///< micrometres
  Angle ball_heading_ = 0;
  int ball_speed_ = 0; ///< micrometres a tick
  int goals_ = 0, kicks_ = 0;
  soccer::GamePhase phase_ = soccer::GamePhase::initial;
  bool hidden_ = false; ///< somebody stands in front of the camera
};

} // namespace sim
