// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: this is not a trigger of the behaviour
#include "porter.hpp"

bool outside(porter::Behaviour& behaviour) {
#ifdef MISTAKE
  return behaviour.fire<porter::Carry>();
#else
  return behaviour.fire<porter::Bump>();
#endif
}
