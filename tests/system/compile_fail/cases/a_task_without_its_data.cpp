// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: deleted
#include "porter.hpp"

director::Outcome body(porter::Carry::Default& run) {
#ifdef MISTAKE
  return run.bring(porter::Drive{}, porter::Grip{});
#else
  return run.bring(porter::Drive{porter_test::Cargo{}}, porter::Grip{});
#endif
}
