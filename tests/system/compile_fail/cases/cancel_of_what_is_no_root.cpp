// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: only tasks that stand in `roots` can be cancelled from outside
#include "porter.hpp"

bool outside(porter::Behaviour& behaviour) {
#ifdef MISTAKE
  return behaviour.post().cancel<porter::Grip>();
#else
  return behaviour.post().cancel<porter::Carry>();
#endif
}
