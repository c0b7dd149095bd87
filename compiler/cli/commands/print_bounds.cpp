// Header: compiler/cli/commands/print_bounds.hpp. Test: tests/compiler/cli/commands/print_bounds_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/commands/print_bounds.hpp"

#include "runtime/core/engine/engine.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace director::compiler::cli {

namespace {

/// As in the example on the page.
constexpr std::int64_t work_budget = 2000;

/// The nearest whole number.
std::int64_t whole(double number) {
  return number < 9e18 ? std::llround(number) : std::numeric_limits<std::int64_t>::max();
}

/// With its unit and two digits: `1.2 us`, `450 ms`; long times in hours.
std::string rounded_time(double nanoseconds) {
  struct Unit {
    double nanoseconds;
    const char* name;
  };
  static constexpr Unit units[]{{3600e9, "h"}, {1e9, "s"}, {1e6, "ms"}, {1e3, "us"}, {1, "ns"}};
  for (const Unit& unit : units) {
    const double count = nanoseconds / unit.nanoseconds;
    if (count >= 9.95) return fmt::format("{:.0f} {}", count, unit.name);
    if (count >= 1 || unit.nanoseconds == 1) return fmt::format("{:.1f} {}", count, unit.name);
  }
  return {};
}

} // namespace

std::string bounds_text(const analysis::Bounds& bounds, const Model& model, const std::string& file, double work_ns) {
  std::string out = fmt::format("memory and bounds of {}\n", file);
  const auto line = [&](std::string_view what, std::int64_t number, std::string_view unit, const std::string& more) {
    out += fmt::format("  {:<17}{:>8} {}{}{}\n", what, number, unit, more.empty() ? "" : "; ", more);
  };
  const std::string least = bounds.counted ? "" : "and more, too many to count";
  const std::string handlers = bounds.handlers_set ? "not counting inputs that handlers cause" : "";
  line("decision state", bounds.decision_bytes, "bytes of RAM", "");
  line("engine", bounds.engine_bytes, "bytes of RAM: decision state and scratch memory of a pass",
       "data of tasks and inbox come on top");
  line("waiting runs", bounds.runs_waiting, "at most", "");
  line("provider trials", bounds.trials, "at most for one decision",
       least.empty() ? fmt::format("`limits: trials` allows {}", model.trials.most) : least);
  line("", bounds.trials_in_a_pass, "at most in one pass",
       least.empty() ? fmt::format("`limits: pass` allows {}", model.pass.most) : least);
  line("work", bounds.work_in_a_pass, "units at most in one pass, with its repetitions", least);
  line("", bounds.work_in_a_micro_step, "units at most in one micro-step", least);
  const auto in_time = [&](std::int64_t work) { return rounded_time(static_cast<double>(work) * work_ns); };
  const auto time = [&](std::string_view what, std::int64_t work, const std::string& of) {
    out += fmt::format("  {:<16}{:>9} {}\n", what, in_time(work), of);
  };
  time("time", bounds.work_in_a_pass,
       fmt::format("at most for one pass, at {:g} ns a unit of work; `--work-ns` says another", work_ns));
  time("", bounds.work_in_a_micro_step, "at most to decide in one micro-step; bodies and observers come on top");
  time("",
       bounds.work_in_a_micro_step > std::numeric_limits<std::int64_t>::max() - work_budget
           ? bounds.work_in_a_micro_step
           : bounds.work_in_a_micro_step + work_budget,
       fmt::format("at most to decide in one step with `set_work_budget({})`", work_budget));
  line("repeated passes", bounds.repetitions, "at most after one micro-step", "");
  line("micro-steps", bounds.to_first_run, "at most from a root request that is granted at once to its run", handlers);
  line("", bounds.calm_input, "at most for an input that changes no decision, if bodies request what they already have",
       handlers);
  line("", Engine::default_budget, "at most in one step, unless the program sets another budget", "");
  return out;
}

Json bounds_json(const analysis::Bounds& bounds, double work_ns) {
  Json out = Json::object(
      {{"decision_state_bytes", Json::number(bounds.decision_bytes)},
       {"engine_bytes", Json::number(bounds.engine_bytes)},
       {"waiting_runs", Json::number(bounds.runs_waiting)},
       {"trials_for_a_decision", Json::number(bounds.trials)},
       {"trials_in_a_pass", Json::number(bounds.trials_in_a_pass)},
       {"trials_counted", Json::boolean(bounds.counted)},
       {"work_in_a_pass", Json::number(bounds.work_in_a_pass)},
       {"work_in_a_micro_step", Json::number(bounds.work_in_a_micro_step)},
       {"nanoseconds_of_a_pass", Json::number(whole(static_cast<double>(bounds.work_in_a_pass) * work_ns))},
       {"nanoseconds_of_a_micro_step", Json::number(whole(static_cast<double>(bounds.work_in_a_micro_step) * work_ns))},
       {"repeated_passes", Json::number(bounds.repetitions)},
       {"micro_steps_to_first_run", Json::number(bounds.to_first_run)},
       {"micro_steps_for_a_calm_input", Json::number(bounds.calm_input)},
       {"micro_steps_in_a_step", Json::number(Engine::default_budget)},
       {"handlers_add_inputs", Json::boolean(bounds.handlers_set)}});
  return out;
}

} // namespace director::compiler::cli
