// Header: this library. Test: tests/system/shared/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "plain.hpp"

#include <chrono>

namespace {

struct Bodies final : plain::Bodies {
  director::Outcome provide(plain::Stand::Default& run) override {
    ++runs;
    return run.keep();
  }
  int runs = 0;
};

} // namespace

extern "C" int count_runs() {
  Bodies bodies;
  plain::Behaviour behaviour{bodies};
  behaviour.request<plain::Stand>();
  behaviour.step(std::chrono::seconds(0));
  behaviour.step(std::chrono::seconds(100));
  return bodies.runs;
}
