#pragma once
// SPDX-License-Identifier: MIT
// Shape: the data that the rover's tasks carry.

namespace rover {

struct Course {
  int degrees = 0;
  int mm_per_s = 0;
};

struct Speed {
  int left = 0, right = 0; ///< mm/s
};

} // namespace rover
