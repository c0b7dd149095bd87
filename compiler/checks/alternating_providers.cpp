// Header: compiler/checks/check.hpp. Test: compiler/checks/alternating_providers.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

namespace {

class Alternating {
public:
  Alternating(const Input& input, Findings& findings)
      : model_(input.model),
        facts_(input.facts),
        requests_(input.shared.requests()),
        findings_(findings) {}

  void look_at(ProviderId first) {
    const Provider& row = model_.providers[first];
    if (!facts_.chosen.contains(first) || row.when.empty()) return;
    for (const ConditionUse& entry : row.sets) {
      if (find_use(first, model_.conditions[entry.id].state) != nullptr && ends(row, entry)) look_at(first, entry);
    }
  }

private:
  /// The condition by which it begins.
  const ConditionUse* find_use(ProviderId id, StateId state) const {
    const std::vector<ConditionUse>& when = model_.providers[id].when;
    const auto at = std::find_if(when.begin(), when.end(),
                                 [&](const ConditionUse& use) { return model_.conditions[use.id].state == state; });
    return at == when.end() ? nullptr : &*at;
  }

  /// Whether it cannot continue with any of these values, and does not aim at a value of this state.
  bool ends(const Provider& row, const ConditionUse& entry) const {
    const Condition& set = model_.conditions[entry.id];
    const Region active = active_region(model_, row);
    const auto at = active.states.find(set.state);
    return at != active.states.end() && !at->second.overlaps(set.accepts) &&
           std::none_of(row.causing.begin(), row.causing.end(),
                        [&](const ConditionUse& promise) { return model_.conditions[promise.id].state == set.state; });
  }

  void look_at(ProviderId first, const ConditionUse& entry) {
    const Provider& row = model_.providers[first];
    const StateId state = model_.conditions[entry.id].state;
    Region here = region_of(model_, row.when);
    for (const auto* entries : {&row.sets, &row.causing}) {
      for (const ConditionUse& each : *entries) {
        const StateId other = model_.conditions[each.id].state;
        here.states[other] = values_set_by(model_, row, other);
      }
    }
    here.states[state] = model_.conditions[entry.id].accepts;
    for (const ProviderId next : model_.groups[row.group].providers) {
      if (next == first || !facts_.chosen.contains(next)) continue;
      const Region own = region_of(model_, model_.providers[next].when);
      if (!compatible(own, here)) continue;
      if (brings_back(first, entry, next)) return report(first, entry, next);
      if (contains(own, here)) return;
    }
  }

  /// Whether the first one is chosen again because of what the next one sets, which says of no value of this state that
  /// it runs with that.
  bool brings_back(ProviderId first, const ConditionUse& entry, ProviderId next) const {
    const StateId state = model_.conditions[entry.id].state;
    const Provider &row = model_.providers[first], &other = model_.providers[next];
    const ValueSet back = values_set_by(model_, other, state);
    if (next < first || find_use(next, state) != nullptr || back.empty()) return false;
    const Region begins = region_of(model_, row.when);
    const bool holds = std::all_of(begins.states.begin(), begins.states.end(), [&](const auto& each) {
      const ValueSet again = values_set_by(model_, other, each.first);
      return (again.empty() ? values_set_by(model_, row, each.first) : again).subset_of(each.second);
    });
    return holds && comes_first(first, state, back) && is_requested(row.group, state, {entry_values(entry), back});
  }

  const ValueSet& entry_values(const ConditionUse& entry) const { return model_.conditions[entry.id].accepts; }

  /// Whether no provider before it is meant for one of these values.
  bool comes_first(ProviderId first, StateId state, const ValueSet& values) const {
    Region here = region_of(model_, model_.providers[first].when);
    here.states[state] = values;
    const std::vector<ProviderId>& all = model_.group_of(first).providers;
    return std::none_of(all.begin(), std::find(all.begin(), all.end(), first), [&](ProviderId id) {
      return facts_.active.contains(id) && find_use(id, state) != nullptr &&
             compatible(region_of(model_, model_.providers[id].when), here);
    });
  }

  /// Whether some request lasts with each of these.
  bool is_requested(GroupId group, StateId state, const std::vector<ValueSet>& values) const {
    const std::vector<Request>& all = requests_.of(group);
    return std::any_of(all.begin(), all.end(), [&](const Request& request) {
      if (!request.requester) return true;
      const Region region =
          facts_.region_to_run(model_, *request.requester, facts_.pushed.contains(*request.requester));
      const auto at = region.states.find(state);
      return at == region.states.end() || std::none_of(values.begin(), values.end(), [&](const ValueSet& each) {
               return !at->second.overlaps(each);
             });
    });
  }

  void report(ProviderId first, const ConditionUse& entry, ProviderId next) {
    const StateId state = model_.conditions[entry.id].state;
    const Provider& other = model_.providers[next];
    const auto is_of_state = [&](const ConditionUse& each) { return model_.conditions[each.id].state == state; };
    const auto promise = std::find_if(other.causing.begin(), other.causing.end(), is_of_state);
    const bool promised = promise != other.causing.end();
    const ConditionUse& back = promised ? *promise : *std::find_if(other.sets.begin(), other.sets.end(), is_of_state);
    const std::string name = name_of(model_, next);
    dsl::Diagnostic& finding = findings_.add(
        entry.span, fmt::format("{} may set {}, which ends it, and {}, which runs then, {} {} again: the two go round",
                                name_of(model_, first), name_of(model_, entry.id), name,
                                promised ? "causes" : "may set", name_of(model_, back.id)));
    const ConditionUse& use = *find_use(first, state);
    finding.notes.push_back(runs_only_while(model_, first, use));
    finding.notes.push_back(
        {back.span, fmt::format("{} {} {}", name, promised ? "causes" : "may set", name_of(model_, back.id))});
    const std::string when =
        fmt::format("say in a `when` of {} with which values of {} it runs", name, name_of(model_, state));
    finding.help = may_stay(first, entry, next)
                       ? fmt::format("{}; or, if they are meant to alternate, {}",
                                     stay_help(model_, {first, use, {}}, entry_values(entry)), when)
                       : when;
  }

  /// Whether others of the group may still run once the first one has a `stay` for its values: not if the state begins
  /// anew with each start of the group, nor if another one is meant for these values.
  bool may_stay(ProviderId first, const ConditionUse& entry, ProviderId next) const {
    const State& state = model_.states[model_.conditions[entry.id].state];
    const GroupId group = model_.providers[first].group;
    const std::vector<ProviderId>& all = model_.groups[group].providers;
    return !(state.of && state.of->id == group) && std::none_of(all.begin(), all.end(), [&](ProviderId id) {
      const ConditionUse* use = id == first || id == next ? nullptr : find_use(id, model_.conditions[entry.id].state);
      return use != nullptr && model_.conditions[use->id].accepts.overlaps(entry_values(entry));
    });
  }

  const Model& model_;
  const Facts& facts_;
  const Requests& requests_;
  Findings& findings_;
};

} // namespace

void alternating_providers(const Input& input, Findings& findings) {
  Alternating alternating(input, findings);
  for (const ProviderId id : input.model.providers.ids()) alternating.look_at(id);
}

} // namespace director::checks
