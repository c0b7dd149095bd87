// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: only tasks that stand in `roots` are requested from outside
#include "porter.hpp"

director::RunState outside(porter::Behaviour& behaviour) {
#ifdef MISTAKE
  return behaviour.state<porter::Grip>();
#else
  return behaviour.state<porter::Carry>();
#endif
}
