// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: a task with data is requested with them: `request\(Task\{data\}\)`
#include "porter.hpp"

bool outside(porter::Behaviour& behaviour) {
#ifdef MISTAKE
  return behaviour.request<porter::Deliver>();
#else
  return behaviour.request(porter::Deliver{porter_test::Cargo{}});
#endif
}
