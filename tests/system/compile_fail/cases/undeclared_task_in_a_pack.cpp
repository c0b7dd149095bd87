// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: bring requests Drive, Grip and Horn only
#include "porter.hpp"

director::Outcome body(porter::Carry::Default& run) {
#ifdef MISTAKE
  return run.bring(porter::Drive{porter_test::Cargo{}}, porter::Grip{}, porter::Open{});
#else
  return run.bring(porter::Drive{porter_test::Cargo{}}, porter::Grip{}, porter::Horn{});
#endif
}
