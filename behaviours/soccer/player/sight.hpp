#pragma once
// SPDX-License-Identifier: MIT
// Shape: where things are from where the robot stands, and where to stand for a shot. Units: world/geometry.hpp.

#include "behaviours/soccer/world/world.hpp"

namespace player {

/// In the robot's own frame: x ahead of it, y to its left.
inline sim::Point seen_from(const sim::Pose& pose, sim::Point place) {
  return sim::turned(place - pose.place, -pose.heading);
}

/// The direction in which the ball has to go.
inline sim::Angle shot(sim::Point ball) { return sim::bearing(sim::goal - ball); }

/// `place` in the frame of the shot: x from the ball towards the goal, y to the left of that.
inline sim::Point along_shot(sim::Point ball, sim::Point place) { return sim::turned(place - ball, -shot(ball)); }

/// A place in the frame of the shot, on the field again.
inline sim::Point beside(sim::Point ball, sim::Point along) { return ball + sim::turned(along, shot(ball)); }

} // namespace player
