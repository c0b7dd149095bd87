// Header: compiler/analysis/states/sources.hpp. Test: tests/compiler/analysis/facts/facts_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/states/sources.hpp"

#include <algorithm>

namespace director::analysis {

namespace {

using Kind = Source::Kind;

struct Collector {
  const Model& model;
  IdTable<StateId, std::vector<Source>> sources;

  void add_own(StateId id) {
    const State& state = model.states[id];
    std::vector<Source>& row = sources[id];
    if (state.initial) row.push_back({Kind::initial, id, ValueSet::single(*state.initial), state.initial_span, {}, {}});
    if (state.external) row.push_back({Kind::external, id, state.domain(), state.name.span, {}, {}});
    if (state.expires && state.expires->to)
      row.push_back({Kind::expires, id, ValueSet::single(*state.expires->to), state.expires->span, {}, {}});
  }

  void add(Kind kind, const std::vector<ConditionUse>& uses, std::optional<ProviderId> provider,
           std::optional<GroupId> group) {
    for (const ConditionUse& use : uses) {
      const Condition& condition = model.conditions[use.id];
      sources[condition.state].push_back({kind, condition.state, condition.accepts, use.span, provider, group});
    }
  }
};

} // namespace

IdTable<StateId, std::vector<Source>> find_sources(const Model& model) {
  Collector collector{model, IdTable<StateId, std::vector<Source>>(model.states.size())};
  for (const StateId id : model.states.ids()) collector.add_own(id);
  for (const ProviderId id : model.providers.ids()) {
    collector.add(Kind::causing, model.providers[id].causing, id, std::nullopt);
    collector.add(Kind::sets, model.providers[id].sets, id, std::nullopt);
  }
  for (const GroupId id : model.groups.ids()) {
    const Group& group = model.groups[id];
    if (group.start) collector.add(Kind::start, group.start->sets, std::nullopt, id);
    if (group.stop) collector.add(Kind::stop, group.stop->sets, std::nullopt, id);
  }
  for (std::vector<Source>& row : collector.sources) {
    if (row.size() == 1 && row.front().kind == Kind::expires) row.clear(); // a state that is never set does not expire
    std::stable_sort(row.begin(), row.end(), [](const Source& a, const Source& b) { return a.kind < b.kind; });
  }
  return std::move(collector.sources);
}

bool acts(const Model& model, const Source& source, const IdSet<ProviderId>& providers) {
  if (source.provider) return providers.contains(*source.provider);
  return !source.group || model.has_any(*source.group, providers);
}

const ConditionUse& promise_of(const Model& model, ProviderId causer, ConditionId condition) {
  const std::vector<ConditionUse>& promises = model.providers[causer].causing;
  return *std::find_if(promises.begin(), promises.end(),
                       [&](const ConditionUse& use) { return model.satisfies(use.id, condition); });
}

ValueSet values_set_by(const Model& model, const Provider& provider, StateId state) {
  ValueSet out;
  for (const std::vector<ConditionUse>* uses : {&provider.causing, &provider.sets}) {
    for (const ConditionUse& use : *uses) {
      if (model.conditions[use.id].state == state) out = out.united(model.conditions[use.id].accepts);
    }
  }
  return out;
}

} // namespace director::analysis
