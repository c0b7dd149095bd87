// Door: compiler/checks/check.hpp. Test: compiler/checks/unbounded_choice.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/plans/plans.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace director::checks {

namespace {

/// Nobody waits for more than this, whatever limit was set.
constexpr std::int64_t most_counted = 1'000'000'000;

/// Providers and plans that a task can be met with; `complete` is false where there are more than could be counted.
struct WayCount {
  std::int64_t count = 0;
  bool complete = true;
};

class Counter {
public:
  Counter(const Model& model, Budget& budget) : model_(model), budget_(budget), ways_(model.groups.size()) {}

  const WayCount& of(GroupId group) {
    std::optional<WayCount>& ways = ways_[group];
    if (ways) return *ways;
    ways = WayCount{};
    for (const ProviderId provider : model_.groups[group].providers) {
      const std::int64_t most = std::min(model_.trials, most_counted) + 1;
      const PlanCount plans = count_plans(model_, provider, most - std::min(ways->count, most - 1), budget_);
      ways->count += plans.plans;
      ways->complete = ways->complete && plans.complete;
    }
    return *ways;
  }

  PlanCount plans_of(ProviderId provider) {
    return count_plans(model_, provider, std::min(model_.trials, most_counted) + 1, budget_);
  }

private:
  const Model& model_;
  Budget& budget_;
  IdTable<GroupId, std::optional<WayCount>> ways_;
};

/// What one decision has to choose for: a task alone, or the members of a unit.
struct CountedUnit {
  std::vector<const Task*> members;
};

bool is_member(const Model& model, const Task& task) {
  const std::vector<Level>& levels = model.edges[task.edge].levels;
  return std::any_of(task.levels.begin(), task.levels.end(), [&](const Task::NamedLevel& named) {
    return !levels[named.level].optional && !levels[named.level].apart;
  });
}

std::vector<CountedUnit> find_units(const Model& model) {
  std::vector<CountedUnit> out;
  for (const Task& root : model.roots) out.push_back({{&root}});
  for (const Provider& provider : model.providers) {
    for (const Pack& pack : provider.packs) {
      CountedUnit members;
      for (const Task& task : pack.tasks) {
        if (is_member(model, task)) {
          members.members.push_back(&task);
        } else {
          out.push_back({{&task}});
        }
      }
      if (!members.members.empty()) out.push_back(std::move(members));
    }
  }
  return out;
}

std::string amount(const WayCount& ways) {
  return fmt::format("{}{} {}", ways.complete ? "" : "at least ", ways.count, ways.count == 1 ? "way" : "ways");
}

void report(const Model& model, const CountedUnit& unit, Counter& counter, std::int64_t product, bool complete,
            Findings& findings) {
  // The task with the most ways is where less would help most.
  const Task* worst = *std::max_element(unit.members.begin(), unit.members.end(), [&](const Task* a, const Task* b) {
    return counter.of(a->target).count < counter.of(b->target).count;
  });
  const bool alone = unit.members.size() == 1;
  dsl::Diagnostic& finding = findings.add(
      worst->span,
      alone ? fmt::format("{} can be met in {}{} ways, and one decision may try {}", name_of(model, worst->target),
                          complete ? "" : "at least ", product, model.trials)
            : fmt::format(
                  "the tasks that are granted with {} can be met in {}{} ways together, and one decision may try {}",
                  name_of(model, worst->target), complete ? "" : "at least ", product, model.trials));
  for (const Task* member : unit.members) {
    if (alone) break;
    finding.notes.push_back(
        {member->span, fmt::format("{}: {}", name_of(model, member->target), amount(counter.of(member->target)))});
  }
  for (const ProviderId provider : model.groups[worst->target].providers) {
    const PlanCount plans = counter.plans_of(provider);
    if (plans.plans > 1)
      finding.notes.push_back(
          {model.providers[provider].span,
           fmt::format("{} has {}{} plans", name_of(model, provider), plans.complete ? "" : "at least ", plans.plans)});
  }
  if (model.trials_span != Span{}) finding.notes.push_back({model.trials_span, "this is the limit"});
  finding.help = alone ? "give the needed groups fewer providers, or raise `limits: {trials: ...}`"
                       : "make one of them `apart`, give the groups fewer providers, or raise `limits: {trials: ...}`";
}

} // namespace

void unbounded_choice(const Input& input, Findings& findings) {
  const Model& model = input.model;
  Budget& budget = input.shared.budget();
  Counter counter(model, budget);
  for (const CountedUnit& unit : find_units(model)) {
    std::int64_t product = 1;
    bool complete = true;
    for (const Task* member : unit.members) {
      const WayCount& ways = counter.of(member->target);
      const std::int64_t factor = std::max<std::int64_t>(ways.count, 1);
      product = product > std::numeric_limits<std::int64_t>::max() / factor ? std::numeric_limits<std::int64_t>::max()
                                                                            : product * factor;
      complete = complete && ways.complete;
    }
    if (product > model.trials || (!complete && !budget.exhausted())) {
      report(model, unit, counter, product, complete, findings);
    } else if (!complete) {
      const Task& first = *unit.members.front();
      budget.leave_open(first.span, fmt::format("in how many ways {} can be met", name_of(model, first.target)));
    }
  }
}

} // namespace director::checks
