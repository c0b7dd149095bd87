// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: this provider has packs: request one of them by its name
#include "porter.hpp"

director::Outcome body(porter::Carry::Default& run) {
#ifdef MISTAKE
  return run.request(porter::Grip{});
#else
  return run.bring(porter::Drive{porter_test::Cargo{}}, porter::Grip{});
#endif
}
