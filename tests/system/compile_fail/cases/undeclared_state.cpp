// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: `causing` and `sets` of this provider or handler do not name this state
#include "porter.hpp"

director::Outcome body(porter::Open::Default& run) {
#ifdef MISTAKE
  run.set(porter::Load::held);
#else
  run.set(porter::Door::open);
#endif
  return run.done();
}
