// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: only states that are `external` can be set from outside
#include "porter.hpp"

bool outside(porter::Behaviour& behaviour) {
#ifdef MISTAKE
  return behaviour.set(porter::Door::open);
#else
  return behaviour.set(porter::Load::lost);
#endif
}
