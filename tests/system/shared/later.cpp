// Header: this library. Test: tests/system/shared/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "plain.hpp"

#include <chrono>

namespace {

struct Bodies final : plain::Bodies {
  template <class Context>
  director::Outcome count(Context& run) {
    ++runs;
    return run.keep();
  }
  director::Outcome provide(plain::Stand::Default& run) override {
    ++runs;
    return run.request(plain::Lean{}, plain::Breathe{});
  }
  director::Outcome provide(plain::Lean::Default& run) override {
    ++runs;
    return run.request(plain::Hip{}, plain::Knee{});
  }
  director::Outcome provide(plain::Breathe::Default& run) override { return count(run); }
  director::Outcome provide(plain::Hip::Default& run) override { return count(run); }
  director::Outcome provide(plain::Knee::Default& run) override { return count(run); }
  int runs = 0;
};

} // namespace

extern "C" int count_runs() {
  Bodies bodies;
  plain::Behaviour behaviour{bodies};
  behaviour.request<plain::Stand>();
  behaviour.step(std::chrono::seconds(0));
  behaviour.step(std::chrono::seconds(15));
  return bodies.runs;
}
