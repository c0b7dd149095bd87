// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: override
#include "porter.hpp"

class Porter : public porter::Porter {
  director::Outcome provide(porter::Carry::Default& run) override { return run.keep(); }
#ifdef MISTAKE
  void start(porter::Grip::Stop&) override {}
#else
  void stop(porter::Grip::Stop&) override {}
#endif
};
