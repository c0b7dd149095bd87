// Header: compiler/lower/steps.hpp. Test: tests/compiler/lower/lower_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/lower/steps.hpp"
#include "compiler/model/closure.hpp"

#include <set>

namespace director::compiler {

namespace {

template <class IdType>
Range rows_of(const std::vector<IdType>& consecutive, std::size_t behind_last) {
  if (consecutive.empty()) return {static_cast<Index>(behind_last), static_cast<Index>(behind_last)};
  return {row(consecutive.front()), static_cast<Index>(row(consecutive.back()) + 1)};
}

/// A provider that is the only one of its group needs no place in a plan.
Range add_slots(const Model& model, GroupId group, Lowered& out) {
  const auto begin = static_cast<Index>(out.plan_groups.size());
  for (const GroupId needed : needed_by(model, group)) {
    if (model.groups[needed].providers.size() > 1) out.plan_groups.push_back(row(needed));
  }
  return {begin, static_cast<Index>(out.plan_groups.size())};
}

Range add_listened(const Model& model, const Group& group, Lowered& out) {
  std::set<Index> triggers;
  for (const ProviderId provider : group.providers) {
    for (const Use<TriggerId>& trigger : model.providers[provider].triggers) triggers.insert(row(trigger.id));
  }
  const auto begin = static_cast<Index>(out.listened.size());
  out.listened.insert(out.listened.end(), triggers.begin(), triggers.end());
  return {begin, static_cast<Index>(out.listened.size())};
}

} // namespace

void lower_groups(const Model& model, Lowered& out) {
  std::vector<std::vector<Index>> owned(model.groups.size());
  for (const StateId state : model.states.ids()) {
    if (model.states[state].of) owned[model.states[state].of->id.value].push_back(row(state));
  }
  for (const GroupId id : model.groups.ids()) {
    const Group& group = model.groups[id];
    director::Group lowered;
    lowered.providers = rows_of(group.providers, model.providers.size());
    lowered.edges = rows_of(group.edges, model.edges.size());
    std::vector<Index> requesters;
    for (const EdgeId edge : group.requesters) requesters.push_back(row(edge));
    lowered.requesters = add_list(out, requesters);
    lowered.slots = add_slots(model, id, out);
    lowered.listens = add_listened(model, group, out);
    lowered.owned = add_list(out, owned[id.value]);
    lowered.start = group.start.has_value();
    lowered.stop = group.stop.has_value();
    out.groups.push_back(lowered);
  }
}

} // namespace director::compiler
