// Header: runtime/hosted/trial.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: this task has no data
#include "porter.hpp"
#include "runtime/hosted/trial.hpp"

void test() {
#ifdef MISTAKE
  director::testing::Trial<porter::Open::Default> open{porter_test::Cargo{}};
#else
  director::testing::Trial<porter::Open::Default> open;
#endif
}
