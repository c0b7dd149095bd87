// Door: compiler/checks/check.hpp. Test: compiler/checks/self_defeating_handler.md.
#include "compiler/checks/analysis/facts.hpp"
#include "compiler/checks/analysis/region.hpp"
#include "compiler/checks/analysis/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

namespace {

class Handlers {
public:
  Handlers(const Input& input, Findings& findings) : model_(input.model), facts_(input.facts), findings_(findings) {}

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

private:
  /// Values of the state with which a provider can run, or go on; nothing: any.
  std::optional<ValueSet> accepted(ProviderId provider, StateId state, bool going) const {
    const Provider& row = model_.providers[provider];
    const Region when = region_of(model_, row.when);
    const Region region = going && !row.stay.empty() ? hull(when, region_of(model_, row.stay)) : when;
    const auto at = region.states.find(state);
    if (at == region.states.end()) return std::nullopt;
    return at->second;
  }

  /// Some other provider that may run beside the same values of all other states accepts some of these.
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

  void look_at_start(GroupId group, const ConditionUse& entry) {
    const Condition& set = model_.conditions[entry.id];
    for (const ProviderId id : active_) {
      const auto starts = accepted(id, set.state, false), stays = accepted(id, set.state, true);
      if (!starts || (!stays || !stays->intersected(set.accepts).empty())) continue;
      if (is_taken_over(id, set.state, set.accepts)) continue;
      const ConditionUse& condition = condition_on(id, set.state);
      dsl::Diagnostic& finding = findings_.add(
          entry.span, fmt::format("the start of {} sets {}, and then {} cannot run any more", name_of(model_, group),
                                  name_of(model_, entry.id), name_of(model_, id)));
      finding.notes.push_back(
          {condition.span, fmt::format("{} runs only while {}", name_of(model_, id), name_of(model_, condition.id))});
      finding.help = fmt::format("let a `stay` of {} accept that value, or let its body set it when it is done",
                                 name_of(model_, id));
      return;
    }
  }

  /// Values that stop the group: under which this provider cannot go on, and no other one can run.
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
      const ConditionUse& condition = condition_on(id, set.state);
      dsl::Diagnostic& finding = findings_.add(
          entry.span, fmt::format("the stop of {} sets {}, and then {} can run again", name_of(model_, group),
                                  name_of(model_, entry.id), name_of(model_, id)));
      finding.notes.push_back({condition.span, fmt::format("{} is stopped when {} does not hold",
                                                           name_of(model_, group), name_of(model_, condition.id))});
      finding.help = "let the stop leave that state as it is, or wait for another one";
      return;
    }
  }

  const Model& model_;
  const Facts& facts_;
  Findings& findings_;
  std::vector<ProviderId> active_;
};

} // namespace

void self_defeating_handler(const Input& input, Findings& findings) {
  Handlers handlers(input, findings);
  for (const GroupId id : input.model.groups.ids()) {
    if (input.facts.requested.contains(id)) handlers.look_at(id);
  }
}

} // namespace director::checks
