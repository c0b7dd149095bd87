// Header: this library. Test: tests/system/shared/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// A library of each version of the lamp, with an observer. It uses what differs: levels, values that may be set, sizes.
#include "lamp.hpp"

#include "runtime/hosted/decision_printer.hpp"

#include <array>
#include <chrono>
#include <cstddef>

namespace {

struct Bodies final : lamp::Bodies {
  director::Outcome provide(lamp::Go::Default& run) override {
    return run.request(lamp::Shine{2, lamp::Shine::fast}, lamp::Beep{});
  }
  director::Outcome provide(lamp::Shine::Default& run) override {
    is_set = run.try_set(static_cast<lamp::Light>(run.task()));
    ++shines;
    return run.keep();
  }
  director::Outcome provide(lamp::Beep::Default& run) override { return run.keep(); }
  director::Outcome provide(lamp::Bulb::Default& run) override { return run.keep(); }
  int shines = 0;
  bool is_set = false;
};

} // namespace

/// How often it shone, and 10 if that has set the light, and 100 if the saved state can be loaded.
extern "C" int count_runs() {
  Bodies bodies;
  director::DecisionPrinter printer{lamp::names::all()};
  lamp::Behaviour behaviour{bodies, printer.observer()}, other{bodies};
  behaviour.request<lamp::Go>();
  behaviour.step(std::chrono::seconds(0));
  std::array<std::byte, lamp::Behaviour::saved_bytes()> saved{};
  const bool is_saved = behaviour.save(saved) == director::SaveResult::saved &&
                        other.load(saved, std::chrono::seconds(0)) == director::LoadResult::loaded;
  return bodies.shines + (bodies.is_set ? 10 : 0) + (is_saved ? 100 : 0);
}
