#pragma once
// SPDX-License-Identifier: MIT
// What an input of a workload takes.

#include "tests/bench/workload.hpp"

namespace bench {

/// In ns an input.
struct Times {
  double mean = 0, p50 = 0, p99 = 0, p999 = 0, max = 0;
  double by_hand = 0;        ///< mean
  double calls = 0;          ///< of providers, an input
  std::size_t heap_uses = 0; ///< in all
};

/// Plays the workload some times, and of each input the least time counts: so what else the machine does falls out.
Times take_times(const Workload& workload);

} // namespace bench
