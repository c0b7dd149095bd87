// Header: compiler/checks/check.hpp. Test: compiler/checks/undone_by_expiry.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/rounds/granted.hpp"
#include "compiler/analysis/rounds/settings.hpp"
#include "compiler/analysis/rounds/spoiling.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"
#include "dsl/lexical/duration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace director::checks {

namespace {

class UndoneByExpiry {
public:
  UndoneByExpiry(const Input& input, Findings& findings)
      : input_(input),
        model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        settings_(input),
        findings_(findings),
        sources_(find_sources(input.model)) {}

  /// What is caused by a push.
  void look_at(const Wanting& wanting) {
    if (std::none_of(wanting.wants.begin(), wanting.wants.end(),
                     [&](const Want& want) { return ends(wanting.task, want); }))
      return;
    for (Granted& any : granted_with(input_, wanting)) {
      for (const Granted& granted : with_each_pack(model_, facts_, shared_, std::move(any), wanting.provider)) {
        const Spoiling spoiling(model_, facts_, granted, wanting.provider);
        spoiling_ = &spoiling;
        for (const Want& want : wanting.wants) look_at(granted, wanting.provider, want);
        spoiling_ = nullptr;
      }
    }
  }

  /// What a group that goes after the task sets without a push.
  void look_at_unpushed(ProviderId waiter) {
    const GroupId task = model_.providers[waiter].group;
    std::optional<Granted> granted;
    for (const ConditionUse& use : model_.providers[waiter].when) {
      const Want want{waiter, use, {}};
      if (!ends(task, want)) continue;
      if (!settings_.may_undo(waiter)) return;
      for (const Source& source : sources_[state_of(want)]) {
        if (source.kind != Source::Kind::sets || !facts_.chosen.contains(*source.provider)) continue;
        const GroupId group = model_.providers[*source.provider].group;
        if (group == task || settings_.is_kept_off(waiter, group)) continue;
        const std::optional<Setting> setting = settings_.find_setting(waiter, use, group, expired(want));
        if (!setting || setting->provider != *source.provider) continue;
        if (!granted) granted.emplace(granted_alone(model_, shared_, task));
        look_at_setting(*granted, active_region(model_, model_.providers[waiter]), want, *setting);
      }
    }
  }

private:
  StateId state_of(const Want& want) const { return model_.conditions[want.condition.id].state; }

  /// What the state becomes; nothing: unset.
  std::optional<ValueSet> expired(const Want& want) const {
    const auto& to = model_.states[state_of(want)].expires->to;
    return to ? std::optional(ValueSet::single(*to)) : std::nullopt;
  }

  /// Whether the waiting provider cannot continue when the state expires. An external one may be set at any time.
  bool ends(GroupId task, const Want& want) const {
    const State& row = model_.states[state_of(want)];
    if (!row.expires || row.external || (want.pushed && !may_last(want, row.expires->after))) return false;
    const std::optional<ValueSet> values = expired(want);
    return values ? !ending_values(model_, task, want, *values).empty() : is_undone_when_unset(model_, task, want);
  }

  /// Whether what is pushed may take longer to cause what it is pushed for, as it says.
  bool may_last(const Want& want, Microseconds time) const {
    const std::optional<Microseconds>& within = promise_of(model_, want.waiter, want.pushed->wanted).within;
    return within && *within > time;
  }

  void look_at(const Granted& granted, ProviderId provider, const Want& want) {
    if (!ends(granted.waits, want)) return;
    Region here = active_region(model_, model_.providers[want.waiter]);
    if (provider != want.waiter) here.meet(active_region(model_, model_.providers[provider]));
    for (const ProviderId causer : want.causers) {
      if (is_requested_beside(shared_, granted, model_.providers[causer].group))
        look_at_setting(granted, here, want, {causer, causes(model_, causer, want.condition.id)});
    }
  }

  /// `here`: where the waiting provider runs.
  void look_at_setting(const Granted& granted, const Region& here, const Want& want, const Setting& setting) {
    if (seen_.count({state_of(want), want.condition.span}) != 0 || !loses(granted, setting.provider, want) ||
        !may_begin_again(setting.provider, want) || !compatible(here, region_of_run(setting.provider)) ||
        is_undone_at_once(granted, want, setting.provider))
      return;
    const std::vector<Source>& sources = sources_[state_of(want)];
    if (std::none_of(sources.begin(), sources.end(),
                     [&](const Source& source) { return may_renew(granted, here, want, source); }))
      report(granted, want, setting);
  }

  /// Whether it may be chosen or pushed when the state has expired.
  bool may_begin_again(ProviderId id, const Want& want) const {
    const Region begins = region_of(model_, model_.providers[id].when);
    const auto at = begins.states.find(state_of(want));
    const std::optional<ValueSet> values = expired(want);
    return at == begins.states.end() || (values && values->subset_of(at->second));
  }

  Region region_of_run(ProviderId id) const { return facts_.region_to_run(model_, id, facts_.pushed.contains(id)); }

  bool loses(const Granted& granted, ProviderId id, const Want& want) const {
    const Takings& takings = granted.takings;
    const GroupId group = model_.providers[id].group;
    return takings.takes(group) || takings.need_taken(id) != nullptr || (takings.may_beat(group) && spoilt(id, want)) ||
           why_refused(granted, id);
  }

  /// How each unit in which its group is requested is blocked, described for the first one.
  std::optional<Taking> why_refused(const Granted& granted, ProviderId id) const {
    std::optional<Taking> out;
    for (const Request& request : shared_.requests().of(model_.providers[id].group)) {
      std::optional<Taking> why = why_unit_ends(model_, facts_, shared_, granted, request, id);
      if (!why) return std::nullopt;
      if (!out) out = std::move(why);
    }
    return out;
  }

  /// The condition that it loses, if nothing else sets that state to what it accepts while the task runs.
  std::optional<Spoilt> spoilt(ProviderId id, const Want& want) const {
    std::optional<Spoilt> out = spoiling_ != nullptr ? spoiling_->of(id, want.condition.id) : std::nullopt;
    if (!out) return out;
    const Condition& lost = model_.conditions[out->condition.id];
    const bool comes_back =
        model_.states[lost.state].external || model_.states[lost.state].expires ||
        std::any_of(sources_[lost.state].begin(), sources_[lost.state].end(), [&](const Source& source) {
          return source.provider && facts_.active.contains(*source.provider) &&
                 source.values.overlaps(lost.accepts);
        });
    return comes_back ? std::nullopt : out;
  }

  /// Whether it may give the state a value that is waited for while the task runs.
  bool may_renew(const Granted& granted, const Region& here, const Want& want, const Source& source) const {
    if (!source.values.overlaps(model_.conditions[want.condition.id].accepts)) return false;
    if (source.group) return facts_.requested.contains(*source.group);
    if (!source.provider || !facts_.active.contains(*source.provider)) return false;
    const GroupId group = model_.providers[*source.provider].group;
    if (!compatible(here, region_of_run(*source.provider))) return false;
    return runs_below(granted.task, group) || runs_below(granted.waits, group) ||
           !loses(granted, *source.provider, want);
  }

  /// With any pack.
  bool runs_below(GroupId task, GroupId group) const {
    const Claims& claims = shared_.claims(task);
    return task == group || (claims.contains(group) && RunsBelow(shared_.branches(), claims, task).contains(group));
  }

  /// Whether the state is set back before it expires: by the stop of the causing group, or by what runs instead of the
  /// provider. undone_by_stop and undone_by_fallback report that.
  bool is_undone_at_once(const Granted& granted, const Want& want, ProviderId causer) const {
    const GroupId id = model_.providers[causer].group;
    const Group& group = model_.groups[id];
    const auto undoes = [&](const ValueSet& values) {
      return !ending_values(model_, granted.waits, want, values).empty();
    };
    const auto stops = [&](ProviderId each) { return !facts_.active.contains(each) || loses(granted, each, want); };
    if (std::all_of(group.providers.begin(), group.providers.end(), stops)) {
      const std::vector<StopValue> values = stop_values(model_, id, state_of(want));
      return std::any_of(values.begin(), values.end(), [&](const StopValue& stop) { return undoes(stop.values); });
    }
    const Region here = region_of(model_, model_.providers[want.waiter].when);
    for (const ProviderId each : group.providers) {
      const Region own = region_of(model_, model_.providers[each].when);
      if (stops(each) || !compatible(here, own)) continue;
      if (undoes(values_set_by(model_, model_.providers[each], state_of(want)))) return true;
      if (contains(own, here)) return false;
    }
    return false;
  }

  void report(const Granted& granted, const Want& want, const Setting& setting) {
    const StateId state = state_of(want);
    seen_.insert({state, want.condition.span});
    const State::Expires& expires = *model_.states[state].expires;
    const GroupId group = model_.providers[setting.provider].group;
    const std::string causing = name_of(model_, setting.provider);
    Taking how = granted.takings.takes(group) ? granted.takings.way_to(group) : Taking{};
    std::string lost = "stops", apart;
    if (const Use<GroupId>* need = granted.takings.need_taken(setting.provider); how.notes.empty() && need != nullptr) {
      std::vector<std::string> names;
      for (const Use<GroupId>* each : granted.takings.needs_taken(setting.provider))
        names.push_back(name_of(model_, each->id));
      lost = fmt::format("loses {}", list_of(names));
      how = granted.takings.way_to(*need, group);
      how.notes.insert(how.notes.begin(), {need->span, fmt::format("{} needs {}", causing, name_of(model_, need->id))});
    } else if (const std::optional<Spoilt> lose = spoilt(setting.provider, want); lose && how.notes.empty()) {
      lost = fmt::format("loses {}", name_of(model_, lose->condition.id));
      how.notes = lose->notes;
      how.notes.insert(how.notes.begin(), runs_only_while(model_, setting.provider, lose->condition));
    } else if (std::optional<Taking> refused = why_refused(granted, setting.provider); refused && how.notes.empty()) {
      how = std::move(*refused);
      if (shared_.requests().of(group).size() == 1) apart = fmt::format("make {} `apart`, or ", name_of(model_, group));
    }
    dsl::Diagnostic& finding = findings_.add(
        expires.span,
        fmt::format("{} expires after {}, and {}, which could renew it, {} when {}, which waits for {}: the two go "
                    "round",
                    name_of(model_, state), dsl::time_text(expires.after), causing, lost, is_granted(model_, granted),
                    name_of(model_, want.condition.id)));
    add_waiter(model_, want, finding.notes);
    finding.notes.push_back(setting.note);
    for (dsl::Note& note : how.notes) finding.notes.push_back(std::move(note));
    const std::string stay =
        expires.to ? stay_help(model_, granted.waits, want, ValueSet::single(*expires.to))
                   : fmt::format("let {} expire to a value, `expires: {{after: ..., to: ...}}`, and {} under which it "
                                 "may be that",
                                 name_of(model_, state), giving_stay(model_, granted.waits, want));
    // A group that is held only as a need does not run.
    const bool runs = is_granted_with(model_, granted.waits, want);
    finding.help = fmt::format("{}{}; or let {} renew it while it runs", apart, stay,
                               runs ? name_of(model_, want.waiter) : name_of(model_, granted.waits));
  }

  const Input& input_;
  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const Settings settings_;
  Findings& findings_;
  const IdTable<StateId, std::vector<Source>> sources_;
  const Spoiling* spoiling_ = nullptr;           ///< of what is granted now, if that was pushed for
  std::set<std::pair<StateId, dsl::Span>> seen_; ///< with the condition that is waited for
};

} // namespace

void undone_by_expiry(const Input& input, Findings& findings) {
  if (std::none_of(input.model.states.begin(), input.model.states.end(),
                   [](const State& state) { return state.expires && !state.external; }))
    return;
  UndoneByExpiry undone(input, findings);
  for (const Wanting& wanting : input.shared.wants()) undone.look_at(wanting);
  for (const Wanting& wanting : input.shared.wants_of_pushed()) undone.look_at(wanting);
  for (const ProviderId id : input.model.providers.ids()) {
    if (input.facts.chosen.contains(id)) undone.look_at_unpushed(id);
  }
}

} // namespace director::checks
