#pragma once
// SPDX-License-Identifier: MIT
// What the thread that steps pays for being observed: a game of soccer with an observer, against the same game without.

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

struct Observed {
  std::string title;         ///< who listens
  std::uint64_t events = 0;  ///< in the game
  double nanoseconds = 0;    ///< more, for each event
  std::uint64_t dropped = 0; ///< events that the recorder's queue had no room for
};

/// Of each step the least time of some replays counts.
std::vector<Observed> observe();

} // namespace bench
