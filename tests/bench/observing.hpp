#pragma once
// SPDX-License-Identifier: MIT
// The cost of an observer for the thread that steps: a game of soccer with an observer, against the same game without
// one.

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

struct Observed {
  std::string title;         ///< the observer
  std::uint64_t events = 0;  ///< events in the game
  double nanoseconds = 0;    ///< additional time of each event
  std::uint64_t dropped = 0; ///< events that found the recorder's queue full
};

/// For each step, the least time of several replays counts.
std::vector<Observed> observe();

} // namespace bench
