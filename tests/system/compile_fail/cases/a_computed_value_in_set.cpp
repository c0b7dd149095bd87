// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: constant expression
#include "porter.hpp"

director::Outcome body(porter::Open::Default& run, porter::Door door) {
#ifdef MISTAKE
  run.set(door);
#else
  if (!run.try_set(door)) return run.fail();
#endif
  return run.done();
}
