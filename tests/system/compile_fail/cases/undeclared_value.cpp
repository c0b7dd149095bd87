// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: this_value_is_not_declared_in_causing_or_sets
#include "porter.hpp"

director::Outcome body(porter::Open::Default& run) {
#ifdef MISTAKE
  run.set(porter::Door::shut);
#else
  run.set(porter::Door::open);
#endif
  return run.done();
}
