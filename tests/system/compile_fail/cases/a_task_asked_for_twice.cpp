// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: a task is requested twice
#include "porter.hpp"

director::Outcome body(porter::Open::Default& run) {
#ifdef MISTAKE
  return run.request(porter::Grip{}, director::keep(porter::Grip{}));
#else
  return run.request(director::keep(porter::Grip{}));
#endif
}
