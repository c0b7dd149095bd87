// Header: runtime/core/task.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: `data: void`: a task without data has no `data`
#ifdef MISTAKE
#define NOTHING
#endif
#include "porter.hpp"
