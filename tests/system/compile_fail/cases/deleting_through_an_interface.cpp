// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: protected
#include "porter.hpp"

void end(porter::Porter* module) {
#ifdef MISTAKE
  delete module;
#else
  static_cast<void>(module);
#endif
}
