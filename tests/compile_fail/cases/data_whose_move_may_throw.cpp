// Door: runtime/core/task.hpp. Test: itself.
// Message: Drive: the data of a task are kept without heap; the move constructor and the destructor of
// porter_test::Cargo must be noexcept
#ifdef MISTAKE
#define THROWING_MOVE
#endif
#include "porter.hpp"
