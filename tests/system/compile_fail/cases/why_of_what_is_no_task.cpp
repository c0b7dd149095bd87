// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: this is not a task of the behaviour
#include "porter.hpp"

director::Because outside(porter::Behaviour& behaviour) {
#ifdef MISTAKE
  return behaviour.why<porter::Door>();
#else
  return behaviour.why<porter::Grip>();
#endif
}
