// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: no matching function for call|no matching constructor
#include "porter.hpp"

porter::Behaviour make(porter::Porter& module) {
#ifdef MISTAKE
  return porter::Behaviour{director::Observer{}, module};
#else
  return porter::Behaviour{module, director::Observer{}};
#endif
}
