// Header: runtime/hosted/trial.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: `causing` and `sets` of this provider or handler do not name this state
#include "porter.hpp"
#include "runtime/hosted/trial.hpp"

bool test(const director::testing::Answer<porter::Open::Default>& answer) {
#ifdef MISTAKE
  return answer.sets(porter::Load::held);
#else
  return answer.sets(porter::Door::open);
#endif
}
