// Door: runtime/core/task.hpp. Test: itself.
// Message: `data: void`: a task without data has no `data`
#ifdef MISTAKE
#define NOTHING
#endif
#include "porter.hpp"
