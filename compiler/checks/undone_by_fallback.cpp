// Header: compiler/checks/check.hpp. Test: compiler/checks/undone_by_fallback.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/clashes/granted.hpp"
#include "compiler/analysis/conflicts/settings.hpp"
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

class UndoneByFallback {
public:
  UndoneByFallback(const Input& input, Findings& findings)
      : model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        settings_(input),
        findings_(findings),
        setters_(input.model.states.size()) {
    for (const ProviderId id : model_.providers.ids()) {
      if (!facts_.chosen.contains(id) || model_.providers[id].needs.empty()) continue;
      for (const ConditionUse& entry : model_.providers[id].sets)
        setters_[model_.conditions[entry.id].state].emplace_back(id, entry.id);
    }
  }

  /// What is caused by a push.
  void look_at(const Wanting& wanting) {
    const auto has_needs = [&](ProviderId causer) { return !model_.providers[causer].needs.empty(); };
    const auto may_be_lost = [&](const Want& want) {
      return std::any_of(want.causers.begin(), want.causers.end(), has_needs);
    };
    if (std::none_of(wanting.wants.begin(), wanting.wants.end(), may_be_lost)) return;
    for (Granted& any : granted_with(model_, shared_, wanting.task)) {
      if (!may_take(any, wanting)) continue;
      for (const Granted& granted : with_each_pack(model_, facts_, shared_, std::move(any), wanting.provider)) {
        for (const Want& want : wanting.wants) look_at(granted, wanting, want);
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
  /// Whether some pack takes something of what is pushed.
  static bool may_take(const Granted& granted, const Wanting& wanting) {
    return std::any_of(wanting.wants.begin(), wanting.wants.end(), [&](const Want& want) {
      return std::any_of(want.causers.begin(), want.causers.end(),
                         [&](ProviderId causer) { return granted.takings.need_taken(causer) != nullptr; });
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
    const std::optional<Fallback> fallback = find_fallback(here, want, id, granted.takings);
    if (!fallback || settings_.never_runs(fallback->provider) || is_pushed_for(want, group)) return;
    const std::optional<Setting> setting = settings_.find_setting(want.waiter, want.condition, group, fallback->values);
    if (setting && setting->provider == id && shared_.chains().may_beat(granted.task, group))
      report(granted, want, *setting, *need, *fallback);
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

  void look_at(const Granted& granted, const Wanting& wanting, const Want& want) {
    for (const ProviderId causer : want.causers) {
      if (granted.takings.takes(model_.providers[causer].group)) continue;
      const Use<GroupId>* need = granted.takings.need_taken(causer);
      if (need == nullptr || seen_.count({need->span, want.condition.span}) != 0 ||
          !is_requested_beside(shared_, granted, model_.providers[causer].group))
        continue;
      Region here = region_of(model_, model_.providers[wanting.provider].when);
      here.meet(region_of(model_, model_.providers[want.waiter].when));
      const std::optional<Fallback> fallback = find_fallback(here, want, causer, granted.takings);
      if (fallback) report(granted, want, {causer, causes(model_, causer, want.condition.id)}, *need, *fallback);
    }
  }

  /// The first one that can continue without what is taken, if no earlier one always can.
  std::optional<Fallback> find_fallback(const Region& here, const Want& want, ProviderId causer,
                                        const Takings& takings) const {
    for (const ProviderId id : model_.groups[model_.providers[causer].group].providers) {
      if (id == causer || !facts_.active.contains(id) || takings.need_taken(id) != nullptr) continue;
      const Region own = region_of(model_, model_.providers[id].when);
      if (!compatible(here, own)) continue;
      const std::optional<Fallback> found = find_undoing(want, id);
      if (found || contains(own, here)) return found;
    }
    return std::nullopt;
  }

  std::optional<Fallback> find_undoing(const Want& want, ProviderId id) const {
    const Provider& row = model_.providers[id];
    for (const std::vector<ConditionUse>* entries : {&row.sets, &row.causing}) {
      for (const ConditionUse& entry : *entries) {
        const Condition& set = model_.conditions[entry.id];
        if (set.state != model_.conditions[want.condition.id].state) continue;
        ValueSet values = undoing_values(model_, want.waiter, want.condition.id, set.accepts);
        if (!values.empty()) return Fallback{id, entry, entries == &row.causing, std::move(values)};
      }
    }
    return std::nullopt;
  }

  void report(const Granted& granted, const Want& want, const Setting& setting, const Use<GroupId>& need,
              const Fallback& fallback) {
    std::vector<std::string> names;
    for (const Use<GroupId>* each : granted.takings.needs_taken(setting.provider)) {
      seen_.insert({each->span, want.condition.span});
      names.push_back(name_of(model_, each->id));
    }
    const std::string causing = name_of(model_, setting.provider), lost = list_of(names);
    const std::string set = fmt::format("{} may {} {}", name_of(model_, fallback.provider),
                                        fallback.promised ? "cause" : "set", name_of(model_, fallback.entry.id));
    dsl::Diagnostic& finding = findings_.add(
        need.span, fmt::format("{} loses {} when {}, which waits for {}; instead of it {}: the two go round", causing,
                               lost, is_granted(model_, granted), name_of(model_, want.condition.id), set));
    add_taking(model_, want, setting.note, granted.takings.way_to(need), finding);
    finding.notes.push_back({fallback.entry.span, set});
    finding.help = fmt::format("let {} do without {}, or {}", causing, lost, stay_help(model_, want, fallback.values));
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const Settings settings_;
  Findings& findings_;
  IdTable<StateId, std::vector<std::pair<ProviderId, ConditionId>>> setters_; ///< what they may set, without a promise
  std::set<std::pair<dsl::Span, dsl::Span>> seen_;
};

} // namespace

void undone_by_fallback(const Input& input, Findings& findings) {
  UndoneByFallback undone(input, findings);
  for (const Wanting& wanting : input.shared.wants()) undone.look_at(wanting);
  for (const ProviderId id : input.model.providers.ids()) {
    if (input.facts.chosen.contains(id)) undone.look_at_unpushed(id);
  }
}

} // namespace director::checks
