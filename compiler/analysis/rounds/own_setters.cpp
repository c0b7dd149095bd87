// Header: compiler/analysis/rounds/own_setters.hpp. Test: compiler/checks/undone_by_itself.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/rounds/own_setters.hpp"

#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace director::analysis {

namespace {

/// Whether the group may stop while the task goes on above it: something on the path may run without the next group,
/// with another pack or provider, or with the same one if that is `optional` or `apart`.
bool may_be_dropped(const Input& input, const std::vector<ChainStep>& path, GroupId group, ProviderId waiter) {
  const Model& model = input.model;
  const Region here = region_of(model, model.providers[waiter].when);
  return std::any_of(path.begin(), path.end(), [&](const ChainStep& step) {
    bool leads = false, does_without = false;
    for (const ProviderId id : model.groups[step.from].providers) {
      const Provider& row = model.providers[id];
      const bool goes_on = step.from == model.providers[waiter].group
                               ? id == waiter
                               : input.facts.active.contains(id) && compatible(here, active_region(model, row));
      if (!goes_on) continue;
      does_without = does_without || row.packs.empty();
      for (const Pack& pack : row.packs) {
        bool keeps = false;
        for (const Task& task : pack.tasks) {
          if (!input.shared.claims(task.target).contains(group)) continue;
          leads = true;
          keeps = keeps || ((!pack.name.empty() || pack.tasks.size() == 1) && model.is_always_member(task));
        }
        does_without = does_without || !keeps;
      }
    }
    return leads && does_without;
  });
}

} // namespace

Setter setter_of(const Model& model, ProviderId id) { return {name_of(model, id), model.providers[id].group}; }

Setter start_of(const Model& model, GroupId group) {
  return {fmt::format("the start of {}", name_of(model, group)), group};
}

void visit_set_below(const Input& input, const RunsBelow& below, GroupId group, ProviderId waiter,
                     const std::function<void(const Setter&, const ConditionUse&)>& visit) {
  const Model& model = input.model;
  const Region here = region_of(model, model.providers[waiter].when);
  if (model.groups[group].start) {
    const Setter start = start_of(model, group);
    for (const ConditionUse& entry : model.groups[group].start->sets) visit(start, entry);
  }
  if (model.groups[group].stop && may_be_dropped(input, below.path(group), group, waiter)) {
    const Setter stop{fmt::format("the stop of {}", name_of(model, group)), group};
    for (const ConditionUse& entry : model.groups[group].stop->sets) visit(stop, entry);
  }
  bool comes_first = true; // no earlier one is always chosen
  for (const ProviderId id : model.groups[group].providers) {
    const Provider& provider = model.providers[id];
    if (!input.facts.active.contains(id) || !compatible(here, active_region(model, provider))) continue;
    Setter by = setter_of(model, id);
    by.unpushed = comes_first;
    for (const ConditionUse& entry : provider.sets) visit(by, entry);
    by.promised = true;
    for (const ConditionUse& entry : provider.causing) visit(by, entry);
    if (contains(region_of(model, provider.when), here)) comes_first = false;
  }
}

} // namespace director::analysis
