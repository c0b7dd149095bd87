// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: bring must be given its task Grip
#include "porter.hpp"

director::Outcome body(porter::Carry::Default& run) {
#ifdef MISTAKE
  return run.bring(porter::Drive{porter_test::Cargo{}}, porter::Horn{});
#else
  return run.bring(porter::Grip{}, porter::Drive{porter_test::Cargo{}}); // in any order, and without what is optional
#endif
}
