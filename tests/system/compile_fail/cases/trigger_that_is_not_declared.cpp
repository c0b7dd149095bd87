// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: the provider's `triggers` do not name this trigger
#include "porter.hpp"

director::Outcome body(porter::Carry::Default& run) {
#ifdef MISTAKE
  if (run.triggered<porter::Bell>()) return run.done();
#else
  if (run.triggered<porter::Bump>()) return run.done();
#endif
  return run.keep();
}
