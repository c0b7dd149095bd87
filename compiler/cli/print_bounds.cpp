// Door: compiler/cli/print_bounds.hpp. Test: tests/compiler/cli/bounds_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/print_bounds.hpp"

#include "runtime/core/engine/engine.hpp"

#include <fmt/format.h>

namespace director::compiler::cli {

std::string bounds_text(const analysis::Bounds& bounds, const Model& model, const std::string& file) {
  std::string out = fmt::format("memory and bounds of {}\n", file);
  const auto line = [&](std::string_view what, std::int64_t number, std::string_view unit, const std::string& more) {
    out += fmt::format("  {:<17}{:>8} {}{}{}\n", what, number, unit, more.empty() ? "" : "; ", more);
  };
  const std::string least = bounds.counted ? "" : "and more, too many to count";
  const std::string handlers = bounds.handlers_set ? "not counting inputs that handlers cause" : "";
  line("decision state", bounds.decision_bytes, "bytes of RAM", "");
  line("engine", bounds.engine_bytes, "bytes of RAM", "that and what a pass forgets; without data of tasks and inbox");
  line("waiting runs", bounds.runs_waiting, "at most", "");
  line("provider trials", bounds.trials, "at most for one decision",
       least.empty() ? fmt::format("`limits: trials` allows {}", model.trials.most) : least);
  line("", bounds.trials_in_a_pass, "at most in one pass",
       least.empty() ? fmt::format("`limits: pass` allows {}", model.pass.most) : least);
  line("repeated passes", bounds.repetitions, "at most after one micro-step", "");
  line("micro-steps", bounds.to_first_run, "at most from a root request that is granted at once to its run", handlers);
  line("", bounds.calm_input, "at most for an input that changes no decision, where bodies keep what there is",
       handlers);
  line("", Engine::default_budget, "at most in one step, unless the program sets another budget", "");
  return out;
}

Json bounds_json(const analysis::Bounds& bounds) {
  Json out = Json::object({{"decision_state_bytes", Json::number(bounds.decision_bytes)},
                           {"engine_bytes", Json::number(bounds.engine_bytes)},
                           {"waiting_runs", Json::number(bounds.runs_waiting)},
                           {"trials_for_a_decision", Json::number(bounds.trials)},
                           {"trials_in_a_pass", Json::number(bounds.trials_in_a_pass)},
                           {"trials_counted", Json::boolean(bounds.counted)},
                           {"repeated_passes", Json::number(bounds.repetitions)},
                           {"micro_steps_to_first_run", Json::number(bounds.to_first_run)},
                           {"micro_steps_for_a_calm_input", Json::number(bounds.calm_input)},
                           {"micro_steps_in_a_step", Json::number(Engine::default_budget)},
                           {"handlers_add_inputs", Json::boolean(bounds.handlers_set)}});
  return out;
}

} // namespace director::compiler::cli
