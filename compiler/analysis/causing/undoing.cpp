// Header: compiler/analysis/causing/undoing.hpp. Test: compiler/checks/undone_by_itself.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/undoing.hpp"

#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/states/choice.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/model/closure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace director::analysis {

namespace {

/// Whether one of these can run wherever the conditions of `here` hold.
bool cover(const Model& model, const Region& here, const std::vector<Region>& others) {
  if (std::any_of(others.begin(), others.end(), [&](const Region& each) { return contains(each, here); })) return true;
  if (others.size() < 2) return false;
  IdTable<StateId, ValueSet> domains(model.states.size());
  for (const StateId id : model.states.ids()) domains[id] = model.states[id].domain();
  Budget budget(Budget::of_any_search);
  return find_covering(model, here, others, domains, budget) == Covering::covered;
}

std::optional<ConditionId> wanted_by_push(const Want& want) {
  return want.pushed ? std::optional(want.pushed->wanted) : std::nullopt;
}

/// What a region accepts of a state.
ValueSet accepted_by(const Model& model, const Region& region, StateId state) {
  const auto at = region.states.find(state);
  return at == region.states.end() ? model.states[state].domain() : at->second;
}

/// Whether the task, or what it needs and requests, needs the group and requests it in each of its packs.
bool is_requested_with(const Model& model, GroupId task, GroupId group, std::set<GroupId>& seen) {
  const auto is_needed = [&](const Provider& row) {
    return std::any_of(row.needs.begin(), row.needs.end(), [&](const Use<GroupId>& need) { return need.id == group; });
  };
  const auto has = [&](const Pack& pack) {
    return std::any_of(pack.tasks.begin(), pack.tasks.end(), [&](const Task& each) { return each.target == group; });
  };
  return std::any_of(model.groups[group].requesters.begin(), model.groups[group].requesters.end(), [&](EdgeId id) {
    const std::optional<GroupId>& from = model.edges[id].requester;
    if (!from || !model.edges[id].needed || model.edges[id].levels.empty()) return false;
    if (*from != task && (!seen.insert(*from).second || !is_requested_with(model, task, *from, seen))) return false;
    const std::vector<ProviderId>& all = model.groups[*from].providers;
    return std::all_of(all.begin(), all.end(), [&](ProviderId each) {
      const Provider& row = model.providers[each];
      return !is_needed(row) || (!row.packs.empty() && std::all_of(row.packs.begin(), row.packs.end(), has));
    });
  });
}

/// `wanted`: another provider of the group has to cause this.
ValueSet undoing_values(const Model& model, ProviderId provider, ConditionId condition, const ValueSet& values,
                        bool with_stay, std::optional<ConditionId> wanted) {
  const StateId state = model.conditions[condition].state;
  const Provider& row = model.providers[provider];
  ValueSet out = values.without(model.conditions[condition].accepts);
  if (with_stay && !row.stay.empty()) out = out.without(accepted_by(model, region_of(model, row.stay), state));
  Region here = region_of(model, row.when);
  here.states.erase(state);
  std::vector<std::pair<ValueSet, Region>> others; // what each accepts of the state, and its other conditions
  for (const ProviderId id : model.groups[row.group].providers) {
    Region region = region_of(model, model.providers[id].when);
    if (id == provider || (wanted && !model.causes(id, *wanted)) || !compatible(here, region)) continue;
    ValueSet accepted = accepted_by(model, region, state);
    region.states.erase(state);
    others.emplace_back(std::move(accepted), std::move(region));
  }
  for (const auto& [accepted, region] : others) {
    const ValueSet part = out.intersected(accepted);
    std::vector<Region> regions;
    for (const auto& [also, other] : others) {
      if (part.subset_of(also)) regions.push_back(other);
    }
    if (!part.empty() && cover(model, here, regions)) out = out.without(part);
  }
  return out;
}

} // namespace

ValueSet undoing_values(const Model& model, ProviderId provider, ConditionId condition, const ValueSet& values) {
  return undoing_values(model, provider, condition, values, true, std::nullopt);
}

ValueSet undoing_values(const Model& model, GroupId task, const Want& want, const ValueSet& values, Timing timing) {
  return undoing_values(model, want.waiter, want.condition.id, values, is_granted_with(model, task, want, timing),
                        wanted_by_push(want));
}

ValueSet ending_values(const Model& model, GroupId task, const Want& want, const ValueSet& values, Timing timing) {
  const ValueSet out = undoing_values(model, task, want, values, timing);
  const GroupId group = model.providers[want.waiter].group;
  if (out.empty() || group == task || want.pushed) return out;
  std::vector<ProviderId> others;
  for (const ProviderId id : model.groups[task].providers) {
    std::vector<GroupId> needed;
    for (const Use<GroupId>& need : model.providers[id].needs) needed.push_back(need.id);
    add_needed(model, needed);
    if (std::find(needed.begin(), needed.end(), group) == needed.end()) others.push_back(id);
  }
  return without_other_ways(model, others, model.conditions[want.condition.id].state,
                            region_of(model, model.providers[want.waiter].when), out);
}

ValueSet without_other_ways(const Model& model, const std::vector<ProviderId>& others, StateId state, Region here,
                            ValueSet values) {
  here.states.erase(state);
  for (const ProviderId id : others) {
    Region region = region_of(model, model.providers[id].when);
    const ValueSet accepted = accepted_by(model, region, state);
    region.states.erase(state);
    if (contains(region, here)) values = values.without(accepted);
  }
  return values;
}

bool is_undone_when_unset(const Model& model, GroupId task, const Want& want) {
  const Provider& row = model.providers[want.waiter];
  const StateId state = model.conditions[want.condition.id].state;
  const std::optional<ConditionId> wanted = wanted_by_push(want);
  const auto accepts_unset = [&](const Region& region) { return region.states.count(state) == 0; };
  if (!row.stay.empty() && is_granted_with(model, task, want) && accepts_unset(region_of(model, row.stay)))
    return false;
  Region here = region_of(model, row.when);
  here.states.erase(state);
  std::vector<Region> others;
  for (const ProviderId id : model.groups[row.group].providers) {
    Region region = region_of(model, model.providers[id].when);
    if (id != want.waiter && (!wanted || model.causes(id, *wanted)) && accepts_unset(region) &&
        compatible(here, region))
      others.push_back(std::move(region));
  }
  return !cover(model, here, others);
}

std::vector<StopValue> stop_values(const Model& model, GroupId group, StateId state) {
  const Group& owner = model.groups[group];
  const State& row = model.states[state];
  std::vector<StopValue> out;
  if (owner.stop) {
    for (const ConditionUse& entry : owner.stop->sets) {
      if (model.conditions[entry.id].state != state) continue;
      out.push_back({model.conditions[entry.id].accepts, entry.span,
                     fmt::format("the stop of {} may set {}", name_of(model, group), name_of(model, entry.id)),
                     fmt::format("let the stop of {} leave it as it is", name_of(model, group))});
    }
  }
  // The handler's own value takes precedence, but it may not declare one.
  if (row.of && row.of->id == group)
    out.push_back({ValueSet::single(*row.initial), row.of->span,
                   fmt::format("{} is {} again when {} stops", name_of(model, state), row.value_text(*row.initial),
                               name_of(model, group)),
                   "leave `of` out"});
  return out;
}

IdTable<StateId, std::vector<GroupId>> find_stopping(const Model& model) {
  IdTable<StateId, std::vector<GroupId>> out(model.states.size());
  const auto add = [&](StateId state, GroupId group) {
    std::vector<GroupId>& groups = out[state];
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  };
  for (const GroupId group : model.groups.ids()) {
    if (!model.groups[group].stop) continue;
    for (const ConditionUse& entry : model.groups[group].stop->sets) add(model.conditions[entry.id].state, group);
  }
  for (const StateId state : model.states.ids()) {
    if (model.states[state].of) add(state, model.states[state].of->id);
  }
  return out;
}

void add_waiter(const Model& model, const Want& want, std::vector<dsl::Note>& notes) {
  notes.push_back(runs_only_while(model, want.waiter, want.condition));
  if (want.pushed)
    notes.push_back({promise_of(model, want.waiter, want.pushed->wanted).span,
                     fmt::format("{} is pushed by {} for {}", name_of(model, want.waiter),
                                 name_of(model, want.pushed->by), name_of(model, want.pushed->wanted))});
}

std::optional<dsl::Note> stop_that_causes(const Model& model, GroupId group, ConditionId condition) {
  const Condition& wanted = model.conditions[condition];
  for (StopValue& stop : stop_values(model, group, wanted.state)) {
    if (stop.values.overlaps(wanted.accepts)) return dsl::Note{stop.span, std::move(stop.what)};
  }
  return std::nullopt;
}

bool is_granted_with(const Model& model, GroupId task, const Want& want, Timing timing) {
  const GroupId group = model.providers[want.waiter].group;
  if (group == task || timing == Timing::with_grant) return group == task;
  std::set<GroupId> seen{group};
  return is_requested_with(model, task, group, seen);
}

std::string giving_stay(const Model& model, GroupId task, const Want& want) {
  const std::string waiter = name_of(model, want.waiter);
  if (is_granted_with(model, task, want)) return fmt::format("give {} a `stay`", waiter);
  std::string out;
  for (const ChainStep& step : need_path(model, task, model.providers[want.waiter].group))
    out += fmt::format("let {} request {} too, ", name_of(model, step.from), name_of(model, step.to));
  return out + fmt::format("and give {} a `stay`", waiter);
}

std::string stay_help(const Model& model, GroupId task, const Want& want, const ValueSet& values, Timing timing) {
  const StateId state = model.conditions[want.condition.id].state;
  const std::string under =
      fmt::format("under which {} may be {}", name_of(model, state), values_in_words(model.states[state], values));
  if (timing == Timing::later || is_granted_with(model, task, want, timing))
    return fmt::format("{} {}", giving_stay(model, task, want), under);
  const std::string condition = name_of(model, want.condition.id), waiter = name_of(model, want.waiter);
  const std::vector<ProviderId>& all = model.groups[task].providers;
  if (std::any_of(all.begin(), all.end(), [&](ProviderId id) {
        const std::vector<ConditionUse>& when = model.providers[id].when;
        return std::any_of(when.begin(), when.end(),
                           [&](const ConditionUse& use) { return use.id == want.condition.id; });
      }))
    return fmt::format("leave {} out at {}: {} waits for it itself", condition, waiter, name_of(model, task));
  return fmt::format("let {} wait for {} itself instead of {}, with a `stay` {}", name_of(model, task), condition,
                     waiter, under);
}

std::string stay_help(const Model& model, const Want& want, const ValueSet& values) {
  return stay_help(model, model.providers[want.waiter].group, want, values);
}

} // namespace director::analysis
