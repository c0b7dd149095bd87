// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: this_value_is_not_declared_in_causing_or_sets
#include "porter.hpp"

director::Outcome body(porter::Open::Default& run) {
#ifdef MISTAKE
  run.set(porter::Charge{10});
#else
  run.set(porter::Charge{9});
#endif
  return run.done();
}
