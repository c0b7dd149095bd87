#pragma once
// SPDX-License-Identifier: MIT
// Shape: how fast the cart's two wheels turn. Unit: millimetres a second.

namespace chase_ball {

struct WheelSpeeds {
  int left = 0, right = 0;
};

} // namespace chase_ball
