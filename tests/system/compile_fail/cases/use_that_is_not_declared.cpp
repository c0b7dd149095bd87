// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: does not stand in the provider's `uses`
#include "porter.hpp"

director::Outcome body(porter::Carry::Default& run) {
#ifdef MISTAKE
  if (run.uses<porter::Grip>().done()) return run.done();
#else
  if (run.uses<porter::Drive>().done()) return run.done();
#endif
  return run.keep();
}
