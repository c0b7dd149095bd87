// Header: runtime/core/task.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: the data of a task are stored by value: the headers that `cpp` lists must define this type whole
#ifdef MISTAKE
#define INCOMPLETE
#endif
#include "porter.hpp"
