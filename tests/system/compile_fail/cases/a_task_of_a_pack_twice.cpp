// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: bring is given a task twice
#include "porter.hpp"

director::Outcome body(porter::Carry::Default& run) {
#ifdef MISTAKE
  return run.bring(porter::Drive{porter_test::Cargo{}}, porter::Grip{}, director::keep(porter::Grip{}));
#else
  return run.bring(porter::Drive{porter_test::Cargo{}}, director::keep(porter::Grip{}));
#endif
}
