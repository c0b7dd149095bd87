// Header: runtime/core/behaviour.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: abstract
#include "porter.hpp"

class Porter final : public porter::Porter {
  director::Outcome provide(porter::Carry::Default& run) override { return run.keep(); }
  director::Outcome provide(porter::Deliver::Default& run) override { return run.keep(); }
  director::Outcome provide(porter::Open::Default& run) override { return run.keep(); }
  director::Outcome provide(porter::Drive::Default& run) override { return run.keep(); }
  director::Outcome provide(porter::Grip::Default& run) override { return run.keep(); }
  void stop(porter::Grip::Stop&) override {}
#ifndef MISTAKE
  director::Outcome provide(porter::Horn::Default& run) override { return run.keep(); }
#endif
};

Porter robot;
