#pragma once
// SPDX-License-Identifier: MIT
// What the legs of a robot of the team are asked for.

namespace players {

struct Steps {
  int cm_per_s = 0; ///< towards the ball; 0: stand
};

} // namespace players
