// Header: tests/property/small_behaviour.hpp. Test: tests/property/verdicts_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/small_behaviour.hpp"

#include <algorithm>
#include <numeric>

namespace director::property {

namespace {

class SmallWriter {
public:
  explicit SmallWriter(std::uint64_t seed) : r_(seed + 90'000'000) {
    needs_ = r_.one_of({0.15, 0.3, 0.5});
    when_ = r_.one_of({0.15, 0.35, 0.5});
    causing_ = r_.one_of({0.2, 0.4});
    packs_ = r_.one_of({0.3, 0.7});
    priorities_ = r_.chance(0.35) ? std::vector<int>{0, 0, 10} : std::vector<int>{0, 5, 10, 20};
  }

  BehaviourDraft write() {
    draft_.groups.resize(static_cast<std::size_t>(r_.one_of({3, 3, 4, 4, 5, 5})));
    for (std::size_t g = 0; g < draft_.groups.size(); ++g) draft_.groups[g].name = "G" + std::to_string(g);
    write_states();
    if (r_.chance(0.15)) draft_.triggers = {"T"};
    for (std::size_t g = draft_.groups.size(); g-- > 0;) write_group(g);
    write_roots();
    for (std::size_t g = 1; g < draft_.groups.size(); ++g) request(g);
    if (draft_.roots.size() > 1 && r_.chance(0.35)) write_soft_pair();
    return std::move(draft_);
  }

private:
  void write_states() {
    const int count = r_.one_of({1, 1, 2, 2, 3});
    for (int i = 0; i < count; ++i) {
      StateDraft state;
      state.name = "S" + std::to_string(i);
      state.is_range = r_.chance(0.1);
      const int values = r_.one_of({2, 2, 3});
      for (int v = 0; v < values; ++v) state.values.push_back((state.is_range ? "" : "v") + std::to_string(v));
      state.external = r_.chance(0.35);
      if (r_.chance(0.93)) state.initial = r_.below(state.values.size());
      if (state.external && r_.chance(0.08)) {
        state.expires = 20;
        if (r_.chance(0.5)) state.expires_to = r_.below(state.values.size());
      }
      if (!state.external && state.initial && r_.chance(0.25)) state.owner = r_.below(draft_.groups.size());
      draft_.states.push_back(state);
    }
  }

  std::vector<std::size_t> settable(std::size_t group) const {
    std::vector<std::size_t> out;
    for (std::size_t s = 0; s < draft_.states.size(); ++s) {
      if (draft_.states[s].owner.value_or(group) == group) out.push_back(s);
    }
    return out;
  }

  ConditionDraft condition(std::size_t state, bool sets) {
    const std::size_t last = draft_.states[state].values.size() - 1;
    ConditionDraft out{state, "==", {r_.below(last + 1)}, {}};
    if (!sets && r_.chance(0.2)) out.op = "!=";
    if (last > 1 && r_.chance(0.15)) {
      out.op = r_.chance(0.5) ? ">=" : "<";
      out.values = {1 + r_.below(last)};
    }
    return out;
  }

  /// Sometimes two on one state, which may contradict each other.
  std::vector<ConditionDraft> conditions(bool sets, const std::vector<std::size_t>& states) {
    std::vector<ConditionDraft> out;
    const int count = r_.one_of({1, 1, 1, 2});
    if (r_.chance(0.02)) out.push_back(condition(states.front(), sets));
    for (const std::size_t state : r_.some(states, 1, count)) out.push_back(condition(state, sets));
    return out;
  }

  std::vector<std::size_t> all_states() const {
    std::vector<std::size_t> out(draft_.states.size());
    std::iota(out.begin(), out.end(), std::size_t{0});
    return out;
  }

  void write_group(std::size_t g) {
    GroupDraft& group = draft_.groups[g];
    const std::vector<std::size_t> mine = settable(g);
    group.start = r_.chance(0.15), group.stop = r_.chance(0.2);
    if (group.start && !mine.empty() && r_.chance(0.6)) group.start_sets = {condition(r_.one_of(mine), true)};
    if (group.stop && !mine.empty() && r_.chance(0.6)) group.stop_sets = {condition(r_.one_of(mine), true)};
    const int count = r_.one_of({1, 1, 1, 2, 2, 3});
    habits_.assign(draft_.groups.size(), {});
    for (int i = 0; i < count; ++i) group.providers.push_back(provider(g, i + 1 == count ? when_ : 0.85));
    if (count == 1) {
      group.providers.front().name = "default";
    } else {
      for (std::size_t i = 0; i < group.providers.size(); ++i) group.providers[i].name = "p" + std::to_string(i);
    }
  }

  ProviderDraft provider(std::size_t g, double when) {
    ProviderDraft out;
    const std::vector<std::size_t> mine = settable(g);
    if (r_.chance(when)) {
      out.when = conditions(false, all_states());
      if (r_.chance(0.2)) out.stay = conditions(false, all_states());
    }
    if (!mine.empty() && r_.chance(causing_)) out.causing = {condition(r_.one_of(mine), true)};
    if (!mine.empty() && r_.chance(0.12)) {
      out.sets = {condition(r_.one_of(mine), true)};
      if (r_.chance(0.4)) out.sets.front().op.clear();
    }
    std::vector<std::size_t> below(draft_.groups.size() - g - 1);
    std::iota(below.begin(), below.end(), g + 1);
    if (r_.chance(needs_)) out.needs = r_.some(below, 1, r_.one_of({1, 1, 2}));
    write_tasks(g, below, out);
    if (!draft_.triggers.empty() && r_.chance(0.3)) out.triggers = draft_.triggers;
    return out;
  }

  void write_tasks(std::size_t g, const std::vector<std::size_t>& below, ProviderDraft& out) {
    std::vector<TaskDraft> all;
    const auto add = [&](std::size_t target) {
      if (std::none_of(all.begin(), all.end(), [&](const TaskDraft& task) { return task.target == target; }))
        all.push_back(task(target));
    };
    for (const std::size_t need : out.needs) {
      if (r_.chance(0.8)) add(need);
    }
    if (r_.chance(0.75)) {
      for (const std::size_t target : r_.some(below, 1, 3)) add(target);
    }
    if (g > 0 && r_.chance(0.02)) add(r_.below(g)); // a cycle of requests
    if (all.empty()) return;
    if (!r_.chance(packs_)) {
      out.packs.push_back({"", std::move(all)});
      return;
    }
    out.packs.push_back({"whole", all});
    if (r_.chance(0.35)) {
      PackDraft other{"other", {}};
      for (const TaskDraft& each : all) {
        if (r_.chance(0.55)) other.tasks.push_back(r_.chance(0.3) ? TaskDraft{each.target, {level()}} : each);
      }
      out.packs.push_back(std::move(other));
    }
  }

  LevelDraft level() {
    LevelDraft out;
    out.priority = r_.one_of(priorities_);
    out.optional = r_.chance(0.2);
    out.apart = !out.optional && r_.chance(0.2);
    return out;
  }

  TaskDraft task(std::size_t target) {
    std::vector<LevelDraft>& habit = habits_[target];
    if (habit.empty() || r_.chance(0.2)) {
      habit = {level()};
      if (r_.chance(0.06)) {
        habit.front().name = "firm";
        habit.push_back(level());
        habit.back().name = "spare";
      }
    }
    return {target, habit};
  }

  void write_roots() {
    std::vector<std::size_t> upper(std::max<std::size_t>(2, draft_.groups.size() - 2));
    std::iota(upper.begin(), upper.end(), std::size_t{0});
    std::vector<std::size_t> chosen = r_.some(upper, 1, r_.one_of({1, 2, 2, 3}));
    if (r_.chance(0.1)) chosen.push_back(draft_.groups.size() - 1);
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    for (const std::size_t g : chosen) {
      TaskDraft root{g, {level()}};
      root.levels.front().apart = false;
      root.levels.front().optional = r_.chance(0.1);
      draft_.roots.push_back(root);
    }
  }

  /// Groups without a requester are useless here: mostly there is one.
  void request(std::size_t g) {
    const auto wants = [&](const std::vector<TaskDraft>& tasks) {
      return std::any_of(tasks.begin(), tasks.end(), [&](const TaskDraft& task) { return task.target == g; });
    };
    bool wanted = wants(draft_.roots) || r_.chance(0.03);
    for (const GroupDraft& group : draft_.groups) {
      for (const ProviderDraft& each : group.providers) {
        for (const PackDraft& pack : each.packs) wanted = wanted || wants(pack.tasks);
      }
    }
    if (wanted) return;
    std::vector<ProviderDraft>& all = draft_.groups[r_.below(g)].providers;
    ProviderDraft& by = all[r_.below(all.size())];
    if (by.packs.empty()) by.packs.push_back({r_.chance(packs_) ? "whole" : "", {}});
    by.packs.front().tasks.push_back({g, {level()}});
  }

  /// A root task that waits for what a provider of another one causes.
  void write_soft_pair() {
    const std::size_t waits = draft_.roots[0].target, causes = draft_.roots[1].target;
    const std::vector<std::size_t> states = settable(causes);
    if (states.empty()) return;
    const ConditionDraft goal = condition(r_.one_of(states), true);
    for (ProviderDraft& each : draft_.groups[waits].providers) {
      if (r_.chance(0.8)) each.when = {goal};
    }
    GroupDraft& causing = draft_.groups[causes];
    if (causing.providers.size() == 1) {
      causing.providers.front().name = "p0";
      causing.providers.push_back({});
      causing.providers.back().name = "p1";
      causing.providers.back().needs = causing.providers.front().needs;
    }
    causing.providers.back().causing = {goal};
    if (r_.chance(0.6)) draft_.roots[0].levels.front().priority = 30;
  }

  Random r_;
  BehaviourDraft draft_;
  double needs_ = 0, when_ = 0, causing_ = 0, packs_ = 0;
  std::vector<int> priorities_;
  std::vector<std::vector<LevelDraft>>
      habits_; ///< for the current group: the levels at which it requests each other one
};

} // namespace

BehaviourDraft small_behaviour(std::uint64_t seed) { return SmallWriter(seed).write(); }

} // namespace director::property
