// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: this_value_is_not_declared_in_causing_or_sets
#include "porter.hpp"

void handler(porter::Grip::Stop& run) {
#ifdef MISTAKE
  run.set(porter::Load::held);
#else
  run.set(porter::Load::none);
#endif
}
