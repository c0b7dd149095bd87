// Header: runtime/hosted/trial.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: compile this test and the runtime without DIRECTOR_NO_OBSERVER
#ifdef MISTAKE
#define DIRECTOR_NO_OBSERVER
#endif
#include "porter.hpp"
#include "runtime/hosted/trial.hpp"

bool refused(const director::testing::Answer<porter::Open::Default>& answer) {
  return answer.refuses(porter::Charge{50});
}
