// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: only tasks that stand in the provider's `tasks` can be requested
#include "porter.hpp"

director::Outcome body(porter::Open::Default& run) {
#ifdef MISTAKE
  return run.request(porter::Horn{});
#else
  return run.request(porter::Grip{});
#endif
}
