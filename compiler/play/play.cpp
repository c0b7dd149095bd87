// Header: compiler/play/play.hpp. Test: tests/compiler/play/play_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/play.hpp"

#include "compiler/play/input_records.hpp"
#include "compiler/play/scripted_bodies.hpp"
#include "dsl/source/shortened.hpp"
#include "runtime/core/engine/engine.hpp"
#include "runtime/hosted/engine_memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace director::compiler {

namespace {

std::size_t records_of(const ScenarioInput& input) {
  return std::max({std::size_t{1}, input.requests.size(), input.set.size()});
}

/// As many cells as the fullest step needs.
std::size_t inbox_size(const Scenario& scenario) {
  std::size_t most = 2;
  for (const ScenarioStep& step : scenario.steps) {
    std::size_t records = 0;
    for (const ScenarioInput& input : step.inputs) records += records_of(input);
    most = std::max(most, records);
  }
  return std::bit_ceil(most);
}

/// Time stops here, so that adding the longest duration does not overflow.
constexpr Time end_of_time = never - 2 * dsl::longest_duration;

Time advanced(Time now, Time by) { return std::min(now + by, end_of_time); }

class Player {
public:
  Player(const Scenario& scenario, const Model& model, const Lowered& lowered, const PlayOptions& options,
         const Sink& sink)
      : scenario_(scenario),
        model_(model),
        tables_(lowered.view()),
        options_(options),
        onlooker_(options.onlooker),
        most_stops_(options.most_stops),
        bodies_(scenario, tables_, options.onlooker),
        converter_(model, lowered, options.decisions, sink),
        cells_(inbox_size(scenario)),
        inbox_(cells_),
        memory_(tables_),
        engine_(tables_, memory_.state().data(), bodies_.table(), inbox_, converter_.observer()) {
    converter_.share(options.events);
    engine_.set_budget(onlooker_ == nullptr ? play_budget : 1);
  }

  Played play() {
    for (const Setting& given : scenario_.given) {
      engine_.preset(static_cast<Index>(given.state.value), static_cast<std::int32_t>(given.value));
    }
    run_engine(); // time begins: what expires counts from here
    for (const ScenarioStep& step : scenario_.steps) {
      if (options_.steps != 0 && step_ == options_.steps) break;
      const bool is_beyond = options_.until && step.advance && advanced(now_, *step.advance) > *options_.until;
      if (is_beyond && now_ == *options_.until) break;
      converter_.begin_step(++step_);
      converter_.now(now_);
      for (const std::string& shown : step.shown) converter_.input(shown);
      if (!(step.advance ? advance(*step.advance) : take(step.inputs)) || is_beyond) break;
    }
    if (options_.end) options_.end(engine_);
    Played out{step_, exhausted_, too_many_stops_, bodies_.refused(), {}, {}};
    if (!exhausted_ || too_many_stops_) return out;
    const auto [groups, after_done] = converter_.latest();
    for (const GroupId group : groups) out.round.push_back(model_.groups[group].name.value);
    if (after_done && !answers_done(*after_done)) out.after_done = model_.groups[*after_done].name.value;
    return out;
  }

private:
  /// Whether the script says what a provider of the group answers when a task of it is done.
  bool answers_done(GroupId group) const {
    const std::vector<ProviderId>& providers = model_.groups[group].providers;
    return std::any_of(providers.begin(), providers.end(), [&](ProviderId id) {
      const Body& body = scenario_.bodies[id];
      return std::any_of(body.begin(), body.end(),
                         [](const Case& each) { return each.reason == dsl::Reason::subtask_done; });
    });
  }

  /// False: the scenario ends here.
  bool run_engine() {
    switch (onlooker_ == nullptr ? engine_.step(now_) : step_by_step()) {
    case StepResult::quiescent: return true;
    case StepResult::budget_exhausted: return exhaust();
    case StepResult::fault:
    case StepResult::refused: break;
    }
    return false;
  }

  bool exhaust() {
    exhausted_ = true;
    converter_.now(now_);
    converter_.budget_exhausted();
    return false;
  }

  /// The same, with a callback after each micro-step.
  StepResult step_by_step() {
    StepResult result = StepResult::budget_exhausted;
    for (std::uint32_t i = 0; i < play_budget && result == StepResult::budget_exhausted; ++i) {
      result = engine_.step(now_);
      onlooker_->stepped(engine_);
    }
    return result;
  }

  /// The engine runs once for each due time.
  bool advance(Time by) {
    Time until = advanced(now_, by);
    if (options_.until) until = std::min(until, *options_.until);
    for (std::uint64_t stops = 0; engine_.next_due() <= until; ++stops) {
      too_many_stops_ = stops == most_stops_;
      if (too_many_stops_) return exhaust();
      now_ = engine_.next_due();
      if (!run_engine()) return false;
    }
    now_ = until;
    return true;
  }

  bool take(const std::vector<ScenarioInput>& inputs) {
    for (const ScenarioInput& input : inputs) engine_.post(input_records(input, tables_, bodies_.data()));
    return run_engine();
  }

  const Scenario& scenario_;
  const Model& model_;
  const Tables tables_;
  const PlayOptions& options_;
  const Onlooker* onlooker_;
  const std::uint64_t most_stops_;
  ScriptedBodies bodies_;
  EventConverter converter_;
  std::vector<Inbox::Cell> cells_;
  Inbox inbox_;
  EngineMemory memory_;
  Engine engine_;
  Time now_ = 0;
  std::uint32_t step_ = 0;
  bool exhausted_ = false, too_many_stops_ = false;
};

} // namespace

Time time_after(const Scenario& scenario, std::size_t steps) {
  Time now = 0;
  for (std::size_t i = 0; i < steps; ++i) now = advanced(now, scenario.steps[i].advance.value_or(0));
  return now;
}

std::string words_of_round(const Played& played) {
  if (played.round.empty()) return "";
  std::string out = fmt::format(": {} {} again and again", dsl::shortened_list(played.round),
                                played.round.size() == 1 ? "runs" : "run");
  if (!played.after_done.empty())
    out += fmt::format("; a case with `reason: subtask_done` in the script says what {} answers when one of its tasks "
                       "is done",
                       played.after_done);
  return out;
}

Played play(const Scenario& scenario, const Model& model, const Lowered& lowered, const PlayOptions& options,
            const Sink& sink) {
  return Player(scenario, model, lowered, options, sink).play();
}

} // namespace director::compiler
