// Header: runtime/hosted/trial.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: this task has data, which the Trial needs
#include "porter.hpp"
#include "runtime/hosted/trial.hpp"

void test() {
#ifdef MISTAKE
  director::testing::Trial<porter::Drive::Default> drive;
#else
  director::testing::Trial<porter::Drive::Default> drive{porter_test::Cargo{}};
#endif
}
