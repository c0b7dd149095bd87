// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: return-type
#include "porter.hpp"

director::Outcome body(porter::Open::Default& run, bool ready) {
  if (ready) return run.done();
#ifndef MISTAKE
  return run.keep();
#endif
}
