// Header: runtime/core/task.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: the data of a task are stored by value, and this class is abstract
#ifdef MISTAKE
#define ABSTRACT
#endif
#include "porter.hpp"
