// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: only tasks that stand in `roots` can be requested from outside
#include "porter.hpp"

bool outside(porter::Behaviour& behaviour) {
#ifdef MISTAKE
  return behaviour.request<porter::Drive>();
#else
  return behaviour.request<porter::Carry>();
#endif
}
