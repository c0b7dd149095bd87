// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: keep\(\) is for bodies: a request from outside is always a new one
#include "porter.hpp"

bool outside(porter::Behaviour& behaviour) {
#ifdef MISTAKE
  return behaviour.request(director::keep(porter::Deliver{porter_test::Cargo{}}));
#else
  return behaviour.request(porter::Deliver{porter_test::Cargo{}});
#endif
}
