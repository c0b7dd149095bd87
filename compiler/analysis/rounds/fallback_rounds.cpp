// Header: compiler/analysis/rounds/fallback_rounds.hpp. Test: compiler/checks/undone_by_fallback.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/rounds/fallback_rounds.hpp"

#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/rounds/granted.hpp"
#include "compiler/analysis/rounds/stopping_groups.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/words/notes.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace director::analysis {

namespace {

class FallbackSearch {
public:
  explicit FallbackSearch(const Input& input)
      : input_(input),
        model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        settings_(input),
        setters_(input.model.states.size()),
        alternatives_(input.model.states.size()) {
    for (const ProviderId id : model_.providers.ids()) {
      if (!facts_.chosen.contains(id) || model_.providers[id].needs.empty()) continue;
      for (const ConditionUse& entry : model_.providers[id].sets)
        setters_[model_.conditions[entry.id].state].emplace_back(id, entry.id);
    }
    for (const GroupId group : model_.groups.ids()) add_alternatives(group);
  }

  /// What is caused by a push.
  void look_at(const Wanting& wanting) {
    const auto may_lose = [&](ProviderId causer) {
      return !model_.providers[causer].needs.empty() || !model_.providers[causer].when.empty();
    };
    const auto may_be_lost = [&](const Want& want) {
      return !alternatives_[state_of(want)].empty() || std::any_of(want.causers.begin(), want.causers.end(), may_lose);
    };
    if (std::none_of(wanting.wants.begin(), wanting.wants.end(), may_be_lost)) return;
    for (Granted& any : granted_with(input_, wanting)) {
      if (!may_take(any, wanting)) continue;
      for (const Granted& granted : with_each_pack(model_, facts_, shared_, std::move(any), wanting.provider)) {
        const Spoiling spoiling(model_, facts_, granted, wanting.provider);
        for (const Want& want : wanting.wants) look_at(granted, spoiling, wanting, want);
      }
    }
  }

  /// What a group that goes after the task sets without a push.
  void look_at_unpushed(ProviderId waiter) {
    const GroupId task = model_.providers[waiter].group;
    std::optional<Granted> granted;
    for (const ConditionUse& use : model_.providers[waiter].when) {
      for (const auto& [id, entry] : setters_[model_.conditions[use.id].state]) {
        if (model_.providers[id].group == task || !model_.satisfies(entry, use.id)) continue;
        if (!granted) {
          if (!settings_.may_undo(waiter)) return;
          granted.emplace(granted_alone(model_, shared_, task));
        }
        look_at_setter(*granted, {waiter, use, {}}, id);
      }
    }
  }

  std::vector<FallbackRound> take() { return std::move(found_); }

private:
  using Loser = FallbackRound::Loser;
  using Fallback = FallbackRound::Fallback;

  StateId state_of(const Want& want) const { return model_.conditions[want.condition.id].state; }

  /// Of a group of which one provider may set a state, and another one may lose a need and what it requests.
  void add_alternatives(GroupId group) {
    const std::vector<ProviderId>& all = model_.groups[group].providers;
    const auto may_lose = [&](ProviderId id) {
      return facts_.chosen.contains(id) && !model_.providers[id].needs.empty() && !model_.providers[id].packs.empty();
    };
    if (all.size() < 2 || std::none_of(all.begin(), all.end(), may_lose)) return;
    for (const ProviderId id : all) {
      if (!facts_.active.contains(id)) continue;
      for (const std::vector<ConditionUse>* entries : {&model_.providers[id].sets, &model_.providers[id].causing}) {
        for (const ConditionUse& entry : *entries) {
          std::vector<GroupId>& groups = alternatives_[model_.conditions[entry.id].state];
          if (groups.empty() || groups.back() != group) groups.push_back(group);
        }
      }
    }
  }

  /// Whether some pack takes something of what is pushed, or of what may lead to that, or spoils a condition.
  bool may_take(const Granted& granted, const Wanting& wanting) const {
    const auto is_lost = [&](ProviderId id) { return granted.takings.need_taken(id) != nullptr; };
    const Spoiling spoiling(model_, facts_, granted, wanting.provider);
    return std::any_of(wanting.wants.begin(), wanting.wants.end(), [&](const Want& want) {
      const std::vector<GroupId>& groups = alternatives_[state_of(want)];
      const auto is_spoilt = [&](ProviderId id) { return spoiling.of(id, want.condition.id).has_value(); };
      return std::any_of(want.causers.begin(), want.causers.end(), is_lost) ||
             std::any_of(want.causers.begin(), want.causers.end(), is_spoilt) ||
             std::any_of(groups.begin(), groups.end(), [&](GroupId group) {
               const std::vector<ProviderId>& all = model_.groups[group].providers;
               return std::any_of(all.begin(), all.end(), is_lost);
             });
    });
  }

  void look_at_setter(const Granted& granted, const Want& want, ProviderId id) {
    const GroupId group = model_.providers[id].group;
    const Use<GroupId>* need = granted.takings.need_taken(id);
    if (need == nullptr || granted.takings.takes(group) || settings_.is_kept_off(want.waiter, group) ||
        seen_.count({need->span, want.condition.span}) != 0)
      return;
    const Region here = region_of(model_, model_.providers[want.waiter].when);
    // Otherwise it does not run any more then.
    if (!compatible(here, active_region(model_, model_.providers[id]))) return;
    const std::optional<Fallback> fallback = find_fallback(here, granted, want, id);
    if (!fallback || settings_.never_runs(fallback->provider) || is_pushed_for(want, group)) return;
    const std::optional<Setting> setting = settings_.find_setting(want.waiter, want.condition, group, fallback->values);
    if (setting && setting->provider == id) add(granted, want, *setting, {id, need}, *fallback);
  }

  /// Whether the task pushes the group for this condition: then another provider of it causes that.
  bool is_pushed_for(const Want& want, GroupId group) const {
    const std::vector<const Want*> all = shared_.wants_of(model_.providers[want.waiter].group);
    return std::any_of(all.begin(), all.end(), [&](const Want* each) {
      return each->condition.id == want.condition.id &&
             std::any_of(each->causers.begin(), each->causers.end(),
                         [&](ProviderId id) { return model_.providers[id].group == group; });
    });
  }

  void look_at(const Granted& granted, const Spoiling& spoiling, const Wanting& wanting, const Want& want) {
    Region here = region_of(model_, model_.providers[wanting.provider].when);
    here.meet(region_of(model_, model_.providers[want.waiter].when));
    Region later = active_region(model_, model_.providers[wanting.provider]);
    later.meet(active_region(model_, model_.providers[want.waiter]));
    for (const ProviderId causer : want.causers) {
      const GroupId group = model_.providers[causer].group;
      if (granted.takings.takes(group) || !is_requested_beside(shared_, granted, group)) continue;
      Loser loser{causer, granted.takings.need_taken(causer)};
      if (loser.need == nullptr) loser.spoilt = spoiling.of(causer, want.condition.id);
      Region then = loser.spoilt ? later : here; // once it runs, by its `stay` too
      if (loser.spoilt) then.meet(model_.conditions[loser.spoilt->condition.id].state, loser.spoilt->values);
      if (!loser.spoilt || !goes_on_otherwise(granted.waits, then, want))
        look_at_loser(granted, then, want, causer, loser);
      for (const GroupId above : alternatives_[state_of(want)]) look_above(granted, here, want, causer, above);
    }
  }

  /// Whether another provider of the task can run with any value of the state, once the task has set what it sets.
  bool goes_on_otherwise(GroupId task, const Region& then, const Want& want) const {
    std::vector<ProviderId> others = model_.groups[task].providers;
    others.erase(std::remove(others.begin(), others.end(), want.waiter), others.end());
    const ValueSet undoing =
        model_.states[state_of(want)].domain().without(model_.conditions[want.condition.id].accepts);
    return without_other_ways(model_, others, state_of(want), then, undoing).empty();
  }

  /// Where a provider of this group leads to the causing one.
  void look_above(const Granted& granted, const Region& here, const Want& want, ProviderId causer, GroupId above) {
    const GroupId group = model_.providers[causer].group;
    if (above == group || settings_.never_runs(causer) || granted.takings.takes(above) ||
        !shared_.claims(above).contains(group) || leads_to_granted(shared_, above, granted))
      return;
    for (const ProviderId id : model_.groups[above].providers) {
      const Use<GroupId>* need = granted.takings.need_taken(id);
      if (need == nullptr || !facts_.chosen.contains(id) || settings_.never_runs(id) ||
          !compatible(here, facts_.region_to_run(model_, id, facts_.pushed.contains(id))))
        continue;
      const std::vector<ChainStep> down = way_below(model_, shared_, id, group);
      if (!down.empty()) look_at_loser(granted, here, want, causer, {id, need, {}, down});
    }
  }

  void look_at_loser(const Granted& granted, const Region& here, const Want& want, ProviderId causer,
                     const Loser& loser) {
    if ((loser.need == nullptr && !loser.spoilt) || here.empty() ||
        seen_.count({loser.span(), want.condition.span}) != 0)
      return;
    const std::optional<Fallback> fallback = find_fallback(here, granted, want, loser.provider);
    if (!fallback || (loser.provider != causer && (settings_.never_runs(fallback->provider) ||
                                                   !begins_again(loser.provider, want, fallback->values))))
      return;
    if (!stays_requested(input_, granted, model_.providers[loser.provider].group)) return;
    add(granted, want, {causer, causes(model_, causer, want.condition.id)}, loser, *fallback);
  }

  /// Whether its group is requested and chooses the provider when the condition has one of these values.
  bool begins_again(ProviderId id, const Want& want, const ValueSet& values) const {
    Region here = region_of(model_, model_.providers[want.waiter].when);
    here.states[state_of(want)] = values;
    if (!compatible(here, shared_.requests().region(model_.providers[id].group))) return false;
    for (const ProviderId each : model_.group_of(id).providers) {
      const Region own = region_of(model_, model_.providers[each].when);
      if (each == id) return compatible(own, here);
      if (facts_.chosen.contains(each) && contains(own, here)) return false;
    }
    return false;
  }

  /// The first one that can continue without what is taken, if no earlier one always can.
  std::optional<Fallback> find_fallback(const Region& here, const Granted& granted, const Want& want,
                                        ProviderId loser) const {
    for (const ProviderId id : model_.group_of(loser).providers) {
      if (id == loser || !facts_.active.contains(id) || granted.takings.need_taken(id) != nullptr) continue;
      const Region own = region_of(model_, model_.providers[id].when);
      if (!compatible(here, own)) continue;
      const std::optional<Fallback> found = find_undoing(granted.waits, want, id);
      if (found || contains(own, here)) return found;
    }
    return std::nullopt;
  }

  std::optional<Fallback> find_undoing(GroupId task, const Want& want, ProviderId id) const {
    const Provider& row = model_.providers[id];
    for (const std::vector<ConditionUse>* entries : {&row.sets, &row.causing}) {
      for (const ConditionUse& entry : *entries) {
        const Condition& set = model_.conditions[entry.id];
        if (set.state != state_of(want)) continue;
        ValueSet values = ending_values(model_, task, want, set.accepts);
        if (!values.empty()) return Fallback{id, entry, entries == &row.causing, std::move(values)};
      }
    }
    return std::nullopt;
  }

  void add(const Granted& granted, const Want& want, const Setting& setting, const Loser& loser,
           const Fallback& fallback) {
    std::vector<GroupId> needs;
    for (const Use<GroupId>* each : granted.takings.needs_taken(loser.provider)) {
      seen_.insert({each->span, want.condition.span});
      needs.push_back(each->id);
    }
    if (loser.spoilt) seen_.insert({loser.span(), want.condition.span});
    Taking how = loser.spoilt ? Taking{loser.spoilt->notes, {}}
                              : granted.takings.way_to(*loser.need, model_.providers[loser.provider].group);
    found_.push_back(
        {granted.waits, is_granted(model_, granted), want, setting, loser, std::move(needs), std::move(how), fallback});
  }

  const Input& input_;
  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const Settings settings_;
  IdTable<StateId, std::vector<std::pair<ProviderId, ConditionId>>> setters_; ///< what they may set, without a promise
  IdTable<StateId, std::vector<GroupId>> alternatives_; ///< groups of which some provider may set it instead of another
  std::set<std::pair<dsl::Span, dsl::Span>> seen_;      ///< what is lost, and condition
  std::vector<FallbackRound> found_;
};

} // namespace

std::vector<FallbackRound> find_fallback_rounds(const Input& input) {
  FallbackSearch search(input);
  for (const Wanting& wanting : input.shared.wants()) search.look_at(wanting);
  for (const Wanting& wanting : input.shared.wants_of_pushed()) search.look_at(wanting);
  for (const ProviderId id : input.model.providers.ids()) {
    if (input.facts.chosen.contains(id)) search.look_at_unpushed(id);
  }
  return search.take();
}

} // namespace director::analysis
