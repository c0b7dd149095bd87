// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: unused-result
#include "porter.hpp"

director::Outcome body(porter::Open::Default& run) {
#ifdef MISTAKE
  run.done();
#endif
  return run.keep();
}
