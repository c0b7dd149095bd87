// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: this task has no data
#include "porter.hpp"

director::Outcome body([[maybe_unused]] porter::Drive::Default& drive, [[maybe_unused]] porter::Grip::Default& grip) {
#ifdef MISTAKE
  static_cast<void>(grip.task());
#else
  static_cast<void>(drive.task());
#endif
  return grip.done();
}
