// Header: compiler/analysis/clashes/lost_steps.hpp. Test: compiler/checks/push_in_vain.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/clashes/lost_steps.hpp"

#include "compiler/analysis/facts/waiting.hpp"
#include "compiler/analysis/requests/company.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/states/stopped_values.hpp"

#include <algorithm>
#include <optional>

namespace director::analysis {

namespace {

/// Whether it continues with the step's value by its `stay`, whatever the other states are.
bool stays_with(const Model& model, const Provider& provider, const Condition& step) {
  const Region region = region_of(model, provider.stay);
  const auto at = region.states.find(step.state);
  const ValueSet values = values_set_by(model, provider, step.state).intersected(step.accepts);
  return region.states.size() == 1 && at != region.states.end() && values.subset_of(at->second);
}

/// Whether every other provider of the group that sets the step's value has the condition too, or continues until then.
bool holds_before(const Model& model, ProviderId id, const ConditionUse& step, const ConditionUse& use) {
  const Condition& wanted = model.conditions[step.id];
  const std::vector<ProviderId>& all = model.group_of(id).providers;
  return std::all_of(all.begin(), all.end(), [&](ProviderId other) {
    const Provider& row = model.providers[other];
    if (other == id || !values_set_by(model, row, wanted.state).overlaps(wanted.accepts) ||
        stays_with(model, row, wanted))
      return true;
    return std::any_of(row.when.begin(), row.when.end(),
                       [&](const ConditionUse& each) { return model.satisfies(each.id, use.id); });
  });
}

using Sources = IdTable<StateId, std::vector<Source>>;

/// Whether something below the group may bring the condition about before it waits, without a push.
bool comes_below(const Input& input, const Sources& sources, const Claims& below, ConditionId id) {
  const Condition& wanted = input.model.conditions[id];
  const auto comes = [&](const Source& source) {
    if (source.kind == Source::Kind::initial || !source.values.overlaps(wanted.accepts)) return false;
    if (source.provider)
      return input.facts.chosen.contains(*source.provider) &&
             below.contains(input.model.providers[*source.provider].group);
    return !source.group || below.contains(*source.group);
  };
  return std::any_of(sources[wanted.state].begin(), sources[wanted.state].end(), comes);
}

/// What could be pushed for the condition, if nothing below the group itself would bring it about before. What is below
/// is not requested while the group waits.
std::optional<ProviderId> find_pushed(const Input& input, const Sources& sources, GroupId group, ConditionId id) {
  const Claims& below = input.shared.claims(group);
  std::optional<ProviderId> out;
  for (const ProviderId causer : input.shared.causers()[id]) {
    const bool is_below = below.contains(input.model.providers[causer].group);
    if (is_below && comes_below(input, sources, below, id)) return std::nullopt;
    const IdSet<ProviderId>& running = is_below ? input.facts.capable : input.facts.active;
    if (!out && running.contains(causer) && !input.shared.promises().explained.contains(causer)) out = causer;
  }
  return out;
}

} // namespace

std::vector<LostStep> find_lost_steps(const Input& input) {
  const Model& model = input.model;
  const Sources sources = find_sources(model);
  std::vector<LostStep> out;
  Waiting waiting(model, input.facts);
  for (const ProviderId id : model.providers.ids()) {
    const GroupId group = model.providers[id].group;
    const ConditionUse* step = find_own_step(model, id);
    if (step == nullptr || !input.facts.requested.contains(group) || !input.facts.capable.contains(id)) continue;
    if (!waiting.may_wait(group)) continue;
    const StateId own = model.conditions[step->id].state;
    const std::vector<Request>& of_group = input.shared.requests().of(group);
    for (const ConditionUse& use : model.providers[id].when) {
      const StateId state = model.conditions[use.id].state;
      if (state == own || input.facts.is_impossible(id, state) || input.facts.holds_always(model, use.id, Region{}) ||
          holds_before(model, id, *step, use))
        continue;
      const std::optional<ProviderId> causer = find_pushed(input, sources, group, use.id);
      if (!causer || std::any_of(of_group.begin(), of_group.end(), [&](const Request& request) {
            return need_not_be_requested(model, input.facts, input.shared.requests(), request,
                                         {model.providers[*causer].group});
          }))
        continue;
      out.push_back({id, *step, use, *causer});
    }
  }
  return out;
}

} // namespace director::analysis
