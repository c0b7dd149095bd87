// Header: compiler/analysis/causing/self_defeats.hpp. Test: compiler/checks/self_defeating_handler.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/self_defeats.hpp"

#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/states/stopped_values.hpp"

#include <algorithm>
#include <optional>

namespace director::analysis {

namespace {

class Handlers {
public:
  Handlers(const Model& model, const Facts& facts) : model_(model), facts_(facts) {}

  void look_at(GroupId id) {
    const Group& group = model_.groups[id];
    active_.clear();
    for (const ProviderId provider : group.providers) {
      if (facts_.active.contains(provider)) active_.push_back(provider);
    }
    if (group.start) {
      for (const ConditionUse& entry : group.start->sets) look_at_start(id, entry);
    }
    if (group.stop) {
      for (const ConditionUse& entry : group.stop->sets) look_at_stop(id, entry);
    }
  }

  std::vector<SelfDefeat> take() { return std::move(out_); }

private:
  /// Values of the state with which a provider can run, or continue; empty: any.
  std::optional<ValueSet> accepted(ProviderId provider, StateId state, bool going) const {
    const Provider& row = model_.providers[provider];
    const Region when = region_of(model_, row.when);
    const Region region = going && !row.stay.empty() ? hull(when, region_of(model_, row.stay)) : when;
    const auto at = region.states.find(state);
    if (at == region.states.end()) return std::nullopt;
    return at->second;
  }

  /// Whether some other provider that may run with the same values of all other states accepts some of these.
  bool is_taken_over(ProviderId from, StateId state, const ValueSet& values) const {
    Region here = region_of(model_, model_.providers[from].when);
    here.states.erase(state);
    return std::any_of(active_.begin(), active_.end(), [&](ProviderId other) {
      if (other == from) return false;
      const auto accepts = accepted(other, state, false);
      return (!accepts || !accepts->intersected(values).empty()) &&
             compatible(here, region_of(model_, model_.providers[other].when));
    });
  }

  const ConditionUse& condition_on(ProviderId provider, StateId state) const {
    const std::vector<ConditionUse>& when = model_.providers[provider].when;
    return *std::find_if(when.begin(), when.end(),
                         [&](const ConditionUse& use) { return model_.conditions[use.id].state == state; });
  }

  /// Values that the state may have when the group starts: a state of the group has the value that its stop left.
  ValueSet values_before(GroupId group, StateId id) const {
    const State& state = model_.states[id];
    return state.of && state.of->id == group ? values_while_stopped(model_, state).values : facts_.values[id];
  }

  void look_at_start(GroupId group, const ConditionUse& entry) {
    const Condition& set = model_.conditions[entry.id];
    const ValueSet before = values_before(group, set.state);
    for (const ProviderId id : active_) {
      const auto starts = accepted(id, set.state, false), stays = accepted(id, set.state, true);
      if (!starts || starts->intersected(before).empty()) continue;
      if (!stays || !stays->intersected(set.accepts).empty()) continue;
      if (is_taken_over(id, set.state, set.accepts)) continue;
      out_.push_back({group, false, id, entry, condition_on(id, set.state)});
      return;
    }
  }

  /// Values that stop the group: with them this provider cannot continue, and no other one can run.
  bool is_stopped_by(ProviderId id, StateId state) const {
    const std::optional<ValueSet> going = accepted(id, state, true);
    if (!going) return false;
    Region here = region_of(model_, model_.providers[id].when);
    here.states.erase(state);
    ValueSet rest = facts_.values[state].without(*going);
    bool unset = model_.states[state].may_be_unset();
    for (const ProviderId other : active_) {
      if (other == id || !compatible(here, region_of(model_, model_.providers[other].when))) continue;
      const std::optional<ValueSet> more = accepted(other, state, true);
      if (!more) return false;
      rest = rest.without(*more);
    }
    return unset || !rest.empty();
  }

  void look_at_stop(GroupId group, const ConditionUse& entry) {
    const Condition& set = model_.conditions[entry.id];
    for (const ProviderId id : active_) {
      const auto starts = accepted(id, set.state, false);
      if (!starts || !set.accepts.subset_of(*starts) || !is_stopped_by(id, set.state)) continue;
      out_.push_back({group, true, id, entry, condition_on(id, set.state)});
      return;
    }
  }

  const Model& model_;
  const Facts& facts_;
  std::vector<SelfDefeat> out_;
  std::vector<ProviderId> active_;
};

} // namespace

std::vector<SelfDefeat> find_self_defeats(const Model& model, const Facts& facts) {
  Handlers handlers(model, facts);
  for (const GroupId id : model.groups.ids()) {
    if (facts.requested.contains(id)) handlers.look_at(id);
  }
  return handlers.take();
}

} // namespace director::analysis
