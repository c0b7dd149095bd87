// Header: tests/property/generate.hpp. Test: tests/property/generate_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/generate.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace director::property {

namespace {

/// The groups of one way to meet the needs of a provider, a bit each.
using Taken = std::uint64_t;
constexpr std::size_t most_plans = 40; ///< of one provider: the oracle enumerates them

class BehaviourWriter {
public:
  BehaviourWriter(Random& random, const Flavour& flavour, std::size_t groups) : r_(random), f_(flavour) {
    draft_.groups.resize(groups);
    for (std::size_t g = 0; g < groups; ++g) draft_.groups[g].name = "G" + std::to_string(g);
    plans_.resize(groups);
  }

  BehaviourDraft write() {
    write_states();
    for (int i = r_.between(0, 2); i > 0; --i) draft_.triggers.push_back("T" + std::to_string(i));
    std::vector<std::size_t> lower(draft_.groups.size() / 2);
    std::iota(lower.begin(), lower.end(), draft_.groups.size() - lower.size());
    favourites_ = r_.some(lower, 1, 3);
    upwards_ = r_.chance(0.2);
    // The needs of a group are behind it, so that the ways to meet them are known when it is written.
    for (std::size_t g = draft_.groups.size(); g-- > 0;) write_group(g);
    if (r_.chance(0.3)) write_ladder();
    if (f_.moving_unit) write_moving_unit();
    write_roots();
    return std::move(draft_);
  }

private:
  // States and conditions

  void write_states() {
    const int count = r_.one_of({1, 2, 2, 3, 4});
    for (int i = 0; i < count; ++i) {
      StateDraft state;
      state.name = "S" + std::to_string(i);
      state.is_range = r_.chance(0.2);
      const int values = r_.between(2, 4);
      for (int v = 0; v < values; ++v) state.values.push_back((state.is_range ? "" : "v") + std::to_string(v));
      state.first_unordered = !state.is_range && values > 2 && r_.chance(0.15);
      state.external = i == 0 || r_.chance(0.8); // the scenario can always change something
      if (!state.external || r_.chance(0.8)) state.initial = r_.below(state.values.size());
      if (state.external && r_.chance(0.07)) {
        state.expires = r_.one_of({20, 50});
        if (r_.chance(0.5)) state.expires_to = r_.below(state.values.size());
      }
      if (!state.external && r_.chance(0.5)) state.owner = r_.below(draft_.groups.size());
      draft_.states.push_back(state);
    }
  }

  /// States that a group may set.
  std::vector<std::size_t> settable(std::size_t group) const {
    std::vector<std::size_t> out;
    for (std::size_t s = 0; s < draft_.states.size(); ++s) {
      if (draft_.states[s].owner.value_or(group) == group) out.push_back(s);
    }
    return out;
  }

  std::vector<std::size_t> all_states() const {
    std::vector<std::size_t> out(draft_.states.size());
    std::iota(out.begin(), out.end(), std::size_t{0});
    return out;
  }

  ConditionDraft condition(std::size_t state, bool promise) {
    const StateDraft& of = draft_.states[state];
    const std::size_t first = of.first_unordered ? 1 : 0; // the first ordered value
    const std::size_t last = of.values.size() - 1;
    ConditionDraft out{state, "==", {}, {}};
    const bool sure = promise || r_.chance(0.65);
    if (!sure) out.op = r_.one_of({"!=", "<", "<=", ">", ">="});
    if (promise && r_.chance(0.1)) out.op = ">=";
    if (out.op == "==" || out.op == "!=") {
      const bool several = last > 1 && r_.chance(0.15);
      std::vector<std::size_t> values(last + 1);
      std::iota(values.begin(), values.end(), std::size_t{0});
      out.values = r_.some(values, several ? 2 : 1, several ? 2 : 1);
    } else if (out.op == "<") {
      out.values = {first + 1 + r_.below(last - first)};
    } else if (out.op == ">") {
      out.values = {first + r_.below(last - first)};
    } else {
      out.values = {first + r_.below(last - first + 1)};
    }
    return out;
  }

  /// On different states, so that they never contradict each other.
  std::vector<ConditionDraft> conditions(const std::vector<std::size_t>& states, bool promise) {
    std::vector<ConditionDraft> out;
    for (const std::size_t s : r_.some(states, 1, r_.chance(0.25) ? 2 : 1)) out.push_back(condition(s, promise));
    return out;
  }

  // Groups

  void write_group(std::size_t g) {
    GroupDraft& group = draft_.groups[g];
    group.data = r_.chance(0.2);
    group.start = r_.chance(0.7);
    group.stop = r_.chance(0.7);
    const std::vector<std::size_t> states = settable(g);
    if (group.start && !states.empty() && r_.chance(0.05)) group.start_sets = {condition(r_.one_of(states), true)};
    if (group.stop && !states.empty() && r_.chance(0.05)) group.stop_sets = {condition(r_.one_of(states), true)};
    const int count = r_.one_of({1, 1, 2, 2, 2, 3, 4});
    habits_.assign(draft_.groups.size(), {});
    for (int i = 0; i < count; ++i) group.providers.push_back(provider(g, i + 1 == count));
    if (count == 1 && r_.chance(0.7)) {
      group.providers.front().name = "default";
    } else {
      for (std::size_t i = 0; i < group.providers.size(); ++i) group.providers[i].name = "p" + std::to_string(i);
      if (!draft_.triggers.empty() && r_.chance(0.1)) group.triggers = {r_.one_of(draft_.triggers)};
    }
  }

  ProviderDraft provider(std::size_t g, bool last) {
    ProviderDraft out;
    if (r_.chance(last ? f_.when / 2 : f_.when)) {
      out.when = conditions(all_states(), false);
      if (r_.chance(0.2)) out.stay = conditions(all_states(), false);
    }
    const std::vector<std::size_t> mine = settable(g);
    if (!mine.empty() && r_.chance(f_.causing)) {
      out.causing = conditions(mine, true);
      if (r_.chance(0.12)) out.causing.front().within = r_.one_of({10, 30});
    }
    if (!mine.empty() && r_.chance(0.1)) {
      out.sets = {condition(r_.one_of(mine), true)};
      if (r_.chance(0.5)) out.sets.front().op.clear();
    }
    const std::vector<std::size_t> below = behind(g);
    write_needs(g, below, out);
    write_tasks(g, below, out);
    if (!draft_.triggers.empty() && r_.chance(0.3)) out.triggers = {r_.one_of(draft_.triggers)};
    if (r_.chance(0.05)) out.every = r_.one_of({10, 20, 50});
    return out;
  }

  std::vector<std::size_t> behind(std::size_t g) const {
    std::vector<std::size_t> out(draft_.groups.size() - g - 1);
    std::iota(out.begin(), out.end(), g + 1);
    return out;
  }

  /// Groups to request or need: mostly any, often the few shared ones.
  std::vector<std::size_t> wanted(const std::vector<std::size_t>& from, int most) {
    std::vector<std::size_t> shared;
    for (const std::size_t g : favourites_) {
      if (std::find(from.begin(), from.end(), g) != from.end()) shared.push_back(g);
    }
    return r_.some(!shared.empty() && r_.chance(f_.favourite) ? shared : from, 0, most);
  }

  /// Needs that can be met, in not too many ways.
  void write_needs(std::size_t g, const std::vector<std::size_t>& below, ProviderDraft& out) {
    std::vector<Taken> plans{0};
    if (r_.chance(f_.needs)) {
      for (const std::size_t need : wanted(below, 2)) {
        std::vector<Taken> longer;
        for (const Taken plan : plans) {
          for (const Taken other : plans_[need]) {
            const Taken with = other | Taken{1} << need;
            if ((plan & with) == 0) longer.push_back(plan | with);
          }
        }
        if (longer.empty() || longer.size() > most_plans) continue;
        plans = std::move(longer);
        out.needs.push_back(need);
      }
    }
    plans_[g].insert(plans_[g].end(), plans.begin(), plans.end());
  }

  // Tasks

  void write_tasks(std::size_t g, const std::vector<std::size_t>& below, ProviderDraft& out) {
    PackDraft all;
    for (const std::size_t need : out.needs) {
      if (r_.chance(0.9)) all.tasks.push_back(task(g, need, 0.5));
    }
    for (const std::size_t target : wanted(below, 2)) add_task(g, target, all);
    std::vector<std::size_t> anywhere(draft_.groups.size());
    std::iota(anywhere.begin(), anywhere.end(), std::size_t{0});
    anywhere.erase(anywhere.begin() + static_cast<std::ptrdiff_t>(g));
    for (const std::size_t target : r_.some(upwards_ && r_.chance(0.2) ? anywhere : below, 0, 2))
      add_task(g, target, all);
    if (all.tasks.empty()) return;
    out.packs.push_back(all);
    if (r_.chance(0.35)) {
      out.packs.front().name = "whole";
      const int others = r_.between(1, 2);
      for (int i = 0; i < others; ++i) {
        PackDraft other{"pack" + std::to_string(i), {}};
        for (const TaskDraft& each : all.tasks) {
          if (r_.chance(0.6)) other.tasks.push_back(r_.chance(0.4) ? task(g, each.target, 1) : each);
        }
        out.packs.push_back(other);
      }
    }
    std::vector<std::size_t> seen = out.needs;
    for (const TaskDraft& each : all.tasks) {
      if (std::find(seen.begin(), seen.end(), each.target) == seen.end()) seen.push_back(each.target);
    }
    if (r_.chance(0.4)) out.uses = r_.some(seen, 1, 2);
  }

  void add_task(std::size_t g, std::size_t target, PackDraft& pack) {
    const auto same = [&](const TaskDraft& task) { return task.target == target; };
    if (std::none_of(pack.tasks.begin(), pack.tasks.end(), same)) pack.tasks.push_back(task(g, target, 1));
  }

  LevelDraft level(double optional) {
    LevelDraft out;
    out.priority = r_.one_of(f_.priorities);
    out.optional = r_.chance(f_.optional * optional);
    out.apart = !out.optional && r_.chance(f_.apart);
    return out;
  }

  /// Most providers of a group request another group at the same levels.
  TaskDraft task(std::size_t g, std::size_t target, double optional) {
    std::vector<LevelDraft>& habit = habits_[target];
    if (habit.empty() || r_.chance(0.15)) {
      habit = {level(target < g ? 3 : optional)};
      if (r_.chance(f_.levels)) {
        habit.front().name = "firm";
        habit.push_back(level(1.5));
        habit.back().name = "spare";
        if (r_.chance(0.5)) habit.back().optional = true, habit.back().apart = false;
      }
    }
    return {target, habit};
  }

  // Roots, and structures that are too rare by chance

  void write_roots() {
    std::vector<std::size_t> upper(std::max<std::size_t>(2, draft_.groups.size() * 2 / 3));
    std::iota(upper.begin(), upper.end(), std::size_t{0});
    for (const std::size_t g : r_.some(upper, 1, 4)) {
      TaskDraft root{g, {level(0.3)}};
      root.levels.front().apart = false;
      if (r_.chance(f_.levels)) {
        root.levels.front().name = "firm";
        root.levels.push_back(level(1));
        root.levels.back().name = "spare";
        root.levels.back().apart = false;
      }
      draft_.roots.push_back(root);
    }
    std::sort(draft_.roots.begin(), draft_.roots.end(),
              [](const auto& a, const auto& b) { return a.target < b.target; });
    if (draft_.roots.size() > 1 && r_.chance(0.8)) write_soft_pair();
  }

  /// A root task that waits for what a provider of a weaker one causes.
  void write_soft_pair() {
    const std::vector<std::size_t> pair = r_.some(std::vector<std::size_t>{0, 1}, 2, 2);
    TaskDraft& waits = draft_.roots[pair[0]];
    TaskDraft& causes = draft_.roots[pair[1]];
    const std::vector<std::size_t> states = settable(causes.target);
    if (states.empty()) return;
    for (LevelDraft& each : waits.levels) each.priority = 60, each.optional = false;
    for (LevelDraft& each : causes.levels) each.priority = r_.one_of({0, 5});
    const std::size_t state = r_.one_of(states);
    if (r_.chance(0.8)) return write_rungs(waits.target, state);
    ConditionDraft goal{state, "==", {r_.below(draft_.states[state].values.size())}, {}};
    for (ProviderDraft& each : draft_.groups[waits.target].providers) each.when = {goal}, each.stay.clear();
    ProviderDraft& last = draft_.groups[causes.target].providers.back();
    if (r_.chance(0.15)) goal.within = 20;
    last.causing = {goal};
    last.when.clear(), last.stay.clear();
  }

  /// A root task that waits for the last value of a state, and providers of the others that set its values one by one.
  void write_rungs(std::size_t waits, std::size_t state) {
    StateDraft& climbed = draft_.states[state];
    climbed.initial = 0;
    const std::size_t top = climbed.values.size() - 1;
    for (ProviderDraft& each : draft_.groups[waits].providers) {
      each.when = {{state, "==", {top}, {}}};
      each.stay.clear();
    }
    for (std::size_t value = 0; value < top; ++value) {
      const TaskDraft& root = r_.one_of(draft_.roots);
      if (root.target == waits || climbed.owner.value_or(root.target) != root.target) continue;
      GroupDraft& group = draft_.groups[root.target];
      if (group.providers.front().name == "default") group.providers.front().name = "p0";
      ProviderDraft rung;
      rung.name = "p" + std::to_string(group.providers.size());
      rung.when = {{state, "==", {value}, {}}};
      rung.causing = {{state, "==", {value + 1}, {}}};
      if (r_.chance(0.3)) rung.causing.front().within = 10;
      group.providers.push_back(rung);
    }
  }

  /// Provider i takes a state from its value i to its value i + 1.
  void write_ladder() {
    const std::size_t g = r_.below(draft_.groups.size());
    const std::vector<std::size_t> states = settable(g);
    if (states.empty()) return;
    const std::size_t state = r_.one_of(states);
    std::size_t value = 0;
    for (ProviderDraft& each : draft_.groups[g].providers) {
      if (value + 1 >= draft_.states[state].values.size()) return;
      each.when = {{state, "==", {value}, {}}};
      each.causing = {{state, "==", {++value}, {}}};
      each.stay.clear();
    }
  }

  /// A unit is ordered by its first member, which may be requested at a lower level. In between there is a task that is
  /// apart, and leads in two steps to the group of the other member.
  void write_moving_unit() {
    const std::size_t g = r_.below(draft_.groups.size() - 4);
    std::vector<std::size_t> below(draft_.groups.size() - g - 1);
    std::iota(below.begin(), below.end(), g + 1);
    const std::vector<std::size_t> found = r_.some(below, 4, 4);
    const std::size_t apart = found[0], between = found[1], wanted = found[2], first = found[3];
    const PackDraft unit{"",
                         {{first, {{"firm", 50, false, false}, {"spare", 0, false, false}}},
                          {apart, {{"", 20, false, true}}},
                          {wanted, {{"", 0, false, false}}}}};
    for (const auto& [group, pack] : {std::pair{g, unit}, std::pair{apart, PackDraft{"", {{between, {LevelDraft{}}}}}},
                                      std::pair{between, PackDraft{"", {{wanted, {LevelDraft{}}}}}}}) {
      for (ProviderDraft& each : draft_.groups[group].providers) each.packs = {pack}, each.needs.clear();
    }
  }

  Random& r_;
  const Flavour& f_;
  BehaviourDraft draft_;
  std::vector<std::vector<Taken>> plans_; ///< of all providers of a group
  std::vector<std::vector<LevelDraft>>
      habits_; ///< for the current group: the levels at which it requests each other one
  std::vector<std::size_t> favourites_;
  bool upwards_ = false; ///< some tasks lead to earlier groups
};

} // namespace

Flavour random_flavour(Random& random) {
  Flavour out;
  const bool dense = random.chance(0.5);
  if (dense) out.when = 0.65, out.causing = 0.6, out.favourite = 0.6;
  out.needs = random.one_of({0.2, 0.45, 0.6});
  out.optional = random.one_of({0.1, 0.3, 0.5});
  out.levels = random.one_of({0.05, 0.1, 0.35});
  out.diligence = random.one_of({0.1, 0.4, 0.8});
  out.priorities = random.chance(0.4) ? std::vector<int>{0, 0, 0, 10} : std::vector<int>{0, 0, 5, 10, 20, 50};
  return out;
}

BehaviourDraft random_behaviour(Random& random, const Flavour& flavour, std::size_t groups) {
  return BehaviourWriter(random, flavour, groups).write();
}

Documents generate_moving_unit(std::uint64_t seed) {
  Random random(seed + 80'000'000);
  Flavour flavour = random_flavour(random);
  flavour.moving_unit = true;
  const BehaviourDraft behaviour = random_behaviour(random, flavour, static_cast<std::size_t>(random.between(6, 15)));
  return {to_document(behaviour), random_scenario(random, flavour, behaviour)};
}

Documents generate_long(std::uint64_t seed) {
  Random random(seed + 100'000'000);
  Flavour flavour = random_flavour(random);
  flavour.scripted_runs = 20;
  flavour.length = 4;
  const BehaviourDraft behaviour = random_behaviour(random, flavour, static_cast<std::size_t>(random.between(3, 8)));
  return {to_document(behaviour), random_scenario(random, flavour, behaviour)};
}

Documents generate_any(std::uint64_t seed) {
  Random random(seed + 60'000'000);
  switch (random.below(8)) {
  case 0: return generate_parts(seed);
  case 1: return generate_moving_unit(seed);
  case 2: return generate_equals(seed);
  default: break;
  }
  const Flavour flavour = random_flavour(random);
  const auto groups = static_cast<std::size_t>(random.between(5, random.one_of({15, 30, 60})));
  const BehaviourDraft behaviour = random_behaviour(random, flavour, groups);
  return {to_document(behaviour), random_scenario(random, flavour, behaviour)};
}

Documents generate(std::uint64_t seed) {
  Random random(seed);
  const Flavour flavour = random_flavour(random);
  const auto groups = static_cast<std::size_t>(random.chance(0.03) ? random.between(20, 60) : random.between(3, 15));
  const BehaviourDraft behaviour = random_behaviour(random, flavour, groups);
  return {to_document(behaviour), random_scenario(random, flavour, behaviour)};
}

} // namespace director::property
