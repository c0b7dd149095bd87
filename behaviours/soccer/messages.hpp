#pragma once
// SPDX-License-Identifier: MIT
// Shape: the data that the player's tasks carry, and the referee's word. Units: millimetres, hundredths of a degree.

#include "behaviours/soccer/world/geometry.hpp"

namespace soccer {

enum class GamePhase : std::uint8_t { initial, ready, set, playing, finished };

enum class Side : std::uint8_t { left, right };

/// How far one step of both legs carries the robot: ahead, to its left, and round.
struct Stride {
  int forward = 0, left = 0;
  sim::Angle turn = 0;
  bool operator==(const Stride&) const = default;
};

struct WalkTarget {
  sim::Point place;       ///< on the field
  sim::Angle heading = 0; ///< to look into, once there
  int longest = 0;        ///< step
};

struct KickTarget {
  sim::Point place; ///< where the ball should go, on the field
};

struct WalkCommand {
  Stride stride;
  int steps = 0; ///< done after so many; 0: goes on until told otherwise
};

struct KickCommand {
  Side leg = Side::right;
};

struct Gaze {
  sim::Angle yaw = 0; ///< from straight ahead, to the left
};

struct LegMove {
  sim::Angle hip = 0, knee = 0, ankle = 0;
};

struct ArmMove {
  sim::Angle shoulder = 0;
};

struct ServoMove {
  sim::Angle to = 0;
};

} // namespace soccer
