// Header: compiler/checks/check.hpp. Test: compiler/checks/undone_by_fallback.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/rounds/granted.hpp"
#include "compiler/analysis/rounds/settings.hpp"
#include "compiler/analysis/rounds/spoiling.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace director::checks {

namespace {

/// Another provider of the causing group, and what it sets.
struct Fallback {
  ProviderId provider{};
  ConditionUse entry{};
  bool promised = false;
  ValueSet values; ///< of these, those with which the waiter cannot continue
};

/// A provider that loses a need: the causing one, or one whose requests lead to it. Or the causing one loses a
/// condition.
struct Loser {
  ProviderId provider{};
  const Use<GroupId>* need = nullptr;
  std::optional<Spoilt> spoilt{};
  std::vector<ChainStep> down{}; ///< from its group to the causing one
};

class UndoneByFallback {
public:
  UndoneByFallback(const Input& input, Findings& findings)
      : input_(input),
        model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        settings_(input),
        findings_(findings),
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

private:
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
    if (setting && setting->provider == id) report(granted, want, *setting, {id, need}, *fallback);
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
        !shared_.claims(above).contains(group) || leads_to(above, granted))
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
        seen_.count({span_of(loser), want.condition.span}) != 0)
      return;
    const std::optional<Fallback> fallback = find_fallback(here, granted, want, loser.provider);
    if (!fallback || (loser.provider != causer && (settings_.never_runs(fallback->provider) ||
                                                   !begins_again(loser.provider, want, fallback->values))))
      return;
    std::set<GroupId> seen;
    if (!stays_requested(granted, model_.providers[loser.provider].group, seen)) return;
    report(granted, want, {causer, causes(model_, causer, want.condition.id)}, loser, *fallback);
  }

  dsl::Span span_of(const Loser& loser) const {
    return loser.need != nullptr ? loser.need->span : loser.spoilt->condition.span;
  }

  bool leads_to(GroupId above, const Granted& granted) const {
    const Claims& claims = shared_.claims(above);
    return claims.contains(granted.task) || claims.contains(granted.waits);
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

  /// Whether something that requests the group goes on when the task is granted, and with it this request. Another
  /// provider may keep the requests of the one that it replaces.
  bool stays_requested(const Granted& granted, GroupId group, std::set<GroupId>& seen) const {
    if (!seen.insert(group).second) return false;
    const std::vector<Request>& requests = shared_.requests().of(group);
    return std::any_of(requests.begin(), requests.end(), [&](const Request& request) {
      if (!request.requester) return true;
      const GroupId above = model_.providers[*request.requester].group;
      if (leads_to(above, granted) || !granted.takings.may_beat(above)) return true;
      const std::vector<ProviderId>& all = model_.groups[above].providers;
      const bool goes_on = std::any_of(all.begin(), all.end(), [&](ProviderId id) {
        return facts_.active.contains(id) && granted.takings.need_taken(id) == nullptr;
      });
      return goes_on && !granted.takings.takes(above) && !is_refused(granted, request) &&
             stays_requested(granted, above, seen);
    });
  }

  /// Whether its unit lacks another member.
  bool is_refused(const Granted& granted, const Request& request) const {
    if (request.pack->name.empty() || !model_.is_always_member(*request.task)) return false;
    const std::vector<const Task*> unit = unit_members(model_, *request.pack);
    return std::any_of(unit.begin(), unit.end(),
                       [&](const Task* member) { return granted.takings.takes(member->target); });
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

  void report(const Granted& granted, const Want& want, const Setting& setting, const Loser& loser,
              const Fallback& fallback) {
    std::vector<std::string> names;
    for (const Use<GroupId>* each : granted.takings.needs_taken(loser.provider)) {
      seen_.insert({each->span, want.condition.span});
      names.push_back(name_of(model_, each->id));
    }
    if (loser.spoilt) {
      seen_.insert({span_of(loser), want.condition.span});
      names.push_back(name_of(model_, loser.spoilt->condition.id));
    }
    const std::string losing = name_of(model_, loser.provider), lost = list_of(names);
    const std::string set = fmt::format("{} may {} {}", name_of(model_, fallback.provider),
                                        fallback.promised ? "cause" : "set", name_of(model_, fallback.entry.id));
    dsl::Diagnostic& finding =
        findings_.add(span_of(loser),
                      fmt::format("{} loses {} when {}, which waits for {}; instead of it {}: the two go round", losing,
                                  lost, is_granted(model_, granted), name_of(model_, want.condition.id), set));
    Taking how = loser.spoilt ? Taking{loser.spoilt->notes, {}}
                              : granted.takings.way_to(*loser.need, model_.providers[loser.provider].group);
    std::vector<dsl::Note> notes;
    add_chain(model_, loser.down, notes);
    how.notes.insert(how.notes.begin(), notes.begin(), notes.end());
    add_taking(model_, want, setting.note, std::move(how), finding);
    finding.notes.push_back({fallback.entry.span, set});
    const std::string keep =
        loser.spoilt ? stay_help(model_, {loser.provider, loser.spoilt->condition, {}}, loser.spoilt->values)
                     : fmt::format("let {} do without {}", losing, lost);
    finding.help = fmt::format("{}, or {}", keep, stay_help(model_, granted.waits, want, fallback.values));
  }

  const Input& input_;
  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const Settings settings_;
  Findings& findings_;
  IdTable<StateId, std::vector<std::pair<ProviderId, ConditionId>>> setters_; ///< what they may set, without a promise
  IdTable<StateId, std::vector<GroupId>> alternatives_; ///< groups of which some provider may set it instead of another
  std::set<std::pair<dsl::Span, dsl::Span>> seen_;
};

} // namespace

void undone_by_fallback(const Input& input, Findings& findings) {
  UndoneByFallback undone(input, findings);
  for (const Wanting& wanting : input.shared.wants()) undone.look_at(wanting);
  for (const Wanting& wanting : input.shared.wants_of_pushed()) undone.look_at(wanting);
  for (const ProviderId id : input.model.providers.ids()) {
    if (input.facts.chosen.contains(id)) undone.look_at_unpushed(id);
  }
}

} // namespace director::checks
