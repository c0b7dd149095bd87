// Door: compiler/analysis/plans/bounds.hpp. Test: tests/compiler/analysis/plans/bounds_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/plans/bounds.hpp"

#include "compiler/analysis/plans/plans.hpp"
#include "runtime/core/state.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace director::analysis {

namespace {

constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t most_plans = 100'000; ///< of one group; who has more is told of by unbounded_choice

std::int64_t sum(std::int64_t a, std::int64_t b) { return a > most - b ? most : a + b; }
std::int64_t product(std::int64_t a, std::int64_t b) { return b != 0 && a > most / b ? most : a * b; }

class Counting {
public:
  Counting(const Model& model, Bounds& out) : model_(model), out_(out), ways_(model.groups.size()) {}

  void count() {
    for (const Task& root : model_.roots) add(out_.trials_in_a_pass, alone(root));
    for (const compiler::Group& group : model_.groups) {
      std::int64_t worst = 0; // what a group asks for at a time is one pack, or flat list, of one of its providers
      for (const ProviderId id : group.providers) {
        for (const Pack& pack : model_.providers[id].packs) worst = std::max(worst, together(pack));
      }
      add(out_.trials_in_a_pass, worst);
    }
  }

private:
  static void add(std::int64_t& to, std::int64_t more) { to = sum(to, more); }

  /// Providers of a group, each with each of its plans.
  std::int64_t ways(GroupId group) {
    std::optional<std::int64_t>& out = ways_[group];
    if (out) return *out;
    out = 0;
    for (const ProviderId id : model_.groups[group].providers) {
      const PlanCount plans = count_plans(model_, id, most_plans, budget_);
      out_.counted = out_.counted && plans.complete;
      add(*out, plans.plans);
    }
    return *out;
  }

  /// Searched once with conditions and once without, for what is unmet.
  std::int64_t alone(const Task& task) {
    out_.trials = std::max(out_.trials, ways(task.target));
    return product(2, ways(task.target));
  }

  bool may_be(const Task& task, bool member) const {
    const std::vector<compiler::Level>& levels = model_.edges[task.edge].levels;
    return std::any_of(task.levels.begin(), task.levels.end(), [&](const Task::NamedLevel& named) {
      return (!levels[named.level].optional && !levels[named.level].apart) == member;
    });
  }

  /// The unit whole, and each task by itself: where it is none of the unit, below a stale group, or where others wait.
  std::int64_t together(const Pack& pack) {
    std::int64_t unit = 1, out = 0;
    for (const Task& task : pack.tasks) {
      if (may_be(task, true)) unit = product(unit, std::max<std::int64_t>(ways(task.target), 1));
      add(out, alone(task));
    }
    out_.trials = std::max(out_.trials, unit);
    return sum(out, product(2, unit));
  }

  const Model& model_;
  Bounds& out_;
  Budget budget_;
  IdTable<GroupId, std::optional<std::int64_t>> ways_;
};

std::int64_t contended(const Tables& tables) {
  return std::count_if(tables.groups.begin(), tables.groups.end(),
                       [](const director::Group& group) { return group.requesters.size() > 1; });
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
  out.repetitions = contended(tables);
  out.to_first_run = out.calm_input = 1 + out.runs_waiting;
  out.handlers_set = sets_from_handlers(model);
  Counting(model, out).count();
  return out;
}

} // namespace director::analysis
