// Header: runtime/core/task.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: the data of a task are kept without heap: their destructor must be public and noexcept
#ifdef MISTAKE
#define THROWING_DESTRUCTOR
#endif
#include "porter.hpp"
