// Header: runtime/core/api/program.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: compile the program and the runtime without DIRECTOR_NO_OBSERVER
#ifdef MISTAKE
#define DIRECTOR_NO_OBSERVER
#endif
#include "porter.hpp"

porter::Behaviour make(porter::Porter& module) { return porter::Behaviour{module, director::Observer{}}; }
