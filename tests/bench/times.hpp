#pragma once
// SPDX-License-Identifier: MIT
// The time of the inputs of a workload.

#include "tests/bench/workload.hpp"

namespace bench {

/// In ns an input.
struct Times {
  double mean = 0, p50 = 0, p99 = 0, p999 = 0, max = 0;
  double by_hand = 0;        ///< mean
  double calls = 0;          ///< provider calls for each input
  std::size_t heap_uses = 0; ///< of all inputs
};

/// Plays the workload several times; for each input the least time counts, so that other load of the machine is left
/// out.
Times take_times(const Workload& workload);

} // namespace bench
