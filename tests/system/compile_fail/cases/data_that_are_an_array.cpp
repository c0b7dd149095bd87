// Header: runtime/core/task.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: the data of a task are stored by value: `data` must name a class, an enum, a number or a pointer
#ifdef MISTAKE
#define ARRAY
#endif
#include "porter.hpp"
