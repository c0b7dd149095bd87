// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: unused-result
#include "porter.hpp"

bool outside(porter::Behaviour::Post post) {
#ifdef MISTAKE
  post.fire<porter::Bell>();
#endif
  return post.fire<porter::Bell>();
}
