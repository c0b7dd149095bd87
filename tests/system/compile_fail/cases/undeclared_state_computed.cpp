// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: `causing` and `sets` of this provider or handler do not name this state
#include "porter.hpp"

#ifdef MISTAKE
bool body(porter::Open::Default& run, porter::Load load) { return run.try_set(load); }
#else
bool body(porter::Open::Default& run, porter::Door door) { return run.try_set(door); }
#endif
