// Header: runtime/core/task.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: the data of a task are kept without heap: their move constructor must be noexcept
#ifdef MISTAKE
#define THROWING_MOVE
#endif
#include "porter.hpp"
