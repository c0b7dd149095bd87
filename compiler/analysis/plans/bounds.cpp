// Header: compiler/analysis/plans/bounds.hpp. Test: tests/compiler/analysis/plans/bounds_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/plans/bounds.hpp"

#include "compiler/analysis/plans/trials.hpp"
#include "compiler/analysis/plans/work.hpp"
#include "runtime/core/base/state.hpp"

#include <algorithm>

namespace director::analysis {

namespace {

constexpr std::int64_t most_plans = 100'000; ///< of one provider; unbounded_choice reports more

class Counting {
public:
  Counting(const Model& model, Bounds& out) : model_(model), out_(out), trials_(model, most_plans, budget_) {}

  void count(const Tables& tables) {
    for (const compiler::Provider& provider : model_.providers) {
      for (const Pack& pack : provider.packs) {
        decide(trials_.together(pack));
        for (const Task& task : pack.tasks) decide(trials_.alone(task));
      }
    }
    for (const Task& root : model_.roots) decide(trials_.alone(root));
    for (const PassTrials& pass : trials_.passes())
      out_.trials_in_a_pass = std::max(out_.trials_in_a_pass, pass.sum.count);
    const WorkBound work = bound_work(model_, tables, trials_);
    out_.work_in_a_pass = work.pass;
    out_.work_in_a_micro_step = work.micro_step;
    out_.counted = out_.counted && work.counted;
  }

private:
  void decide(const CountedUnit& unit) {
    if (unit.members.empty()) return;
    const TrialCount count = trials_.decision(unit);
    out_.trials = std::max(out_.trials, count.count);
    out_.counted = out_.counted && count.complete;
  }

  const Model& model_;
  Bounds& out_;
  Budget budget_;
  Trials trials_;
};

/// Each repetition removes one holder because of which a group was denied to an equal.
std::int64_t groups_of_equals(const Tables& tables) {
  return std::count_if(tables.groups.begin(), tables.groups.end(),
                       [](const director::Group& group) { return group.equals; });
}

bool sets_from_handlers(const Model& model) {
  const auto sets = [](const std::optional<Handler>& handler) { return handler && !handler->sets.empty(); };
  return std::any_of(model.groups.begin(), model.groups.end(),
                     [&](const compiler::Group& group) { return sets(group.start) || sets(group.stop); }) ||
         std::any_of(model.states.begin(), model.states.end(),
                     [](const compiler::State& state) { return state.of.has_value(); });
}

} // namespace

Bounds find_bounds(const Model& model, const Tables& tables) {
  Bounds out;
  const Shape shape = Shape::of(tables);
  out.decision_bytes = static_cast<std::int64_t>(director::State::decision_bytes(shape));
  out.engine_bytes = static_cast<std::int64_t>(director::State::bytes(shape));
  out.runs_waiting = static_cast<std::int64_t>(tables.groups.size());
  out.repetitions = groups_of_equals(tables);
  out.to_first_run = out.calm_input = 1 + out.runs_waiting;
  out.handlers_set = sets_from_handlers(model);
  Counting(model, out).count(tables);
  return out;
}

} // namespace director::analysis
