// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: narrowing
#include "porter.hpp"

bool body(porter::Open::Default& run, double percent) {
#ifdef MISTAKE
  return run.try_set(porter::Charge{percent});
#else
  return run.try_set(porter::Charge{static_cast<int>(percent)});
#endif
}
