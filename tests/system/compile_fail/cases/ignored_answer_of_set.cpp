// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: unused-result
#include "porter.hpp"

bool outside(porter::Behaviour& behaviour) {
#ifdef MISTAKE
  behaviour.set(porter::Load::lost);
#endif
  return behaviour.set(porter::Load::lost);
}
