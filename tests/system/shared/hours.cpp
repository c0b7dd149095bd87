// Header: this library. Test: tests/system/shared/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "hours.hpp"

#include <chrono>

namespace {

struct Bodies final : hours::Bodies {
  director::Outcome provide(hours::Tick::Default& run) override {
    ++runs;
    run.wait(std::chrono::seconds(10));
    return run.keep();
  }
  int runs = 0;
};

} // namespace

extern "C" int count_runs() {
  Bodies bodies;
  hours::Behaviour behaviour{bodies};
  behaviour.request<hours::Tick>();
  behaviour.step(std::chrono::seconds(0));
  behaviour.step(std::chrono::seconds(100));
  return bodies.runs;
}
