// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: this is not a provider of the behaviour
#include "porter.hpp"

bool outside(porter::Behaviour& behaviour) {
#ifdef MISTAKE
  return behaviour.enable<porter::Carry>(false);
#else
  return behaviour.enable<porter::Carry::Default>(false);
#endif
}
