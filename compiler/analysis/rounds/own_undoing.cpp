// Header: compiler/analysis/rounds/own_undoing.hpp. Test: compiler/checks/undone_by_itself.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/rounds/own_undoing.hpp"

#include "compiler/analysis/rounds/granted.hpp"
#include "compiler/analysis/rounds/own_promises.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace director::analysis {

namespace {

class OwnUndoingSearch {
public:
  explicit OwnUndoingSearch(const Input& input)
      : input_(input),
        model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        root_causers_(input.model, input.facts),
        promises_(input) {}

  /// `provider`: of the task; it waits for its own conditions, and for those of what it needs.
  void look_at(const Granted& granted, ProviderId provider, const Want& want) {
    if (!granted.is_other()) {
      const Group& own = model_.groups[granted.task];
      const bool is_need = model_.providers[want.waiter].group != granted.task; // else self_defeating_handler
      if (own.start && is_need) {
        const Setter start = start_of(model_, granted.task);
        for (const ConditionUse& entry : own.start->sets) look_at_entry(granted, want, start, entry);
      }
      for (const ConditionUse& entry : model_.providers[provider].sets)
        look_at_entry(granted, want, setter_of(model_, provider), entry);
      if (!want.pushed && want.waiter == provider) // else it is done then
        for (const ConditionUse& entry : model_.providers[provider].causing) look_at_promise(granted, want, entry);
    }
    for (const GroupId group : granted.below.groups()) {
      if (group == granted.waits) continue;
      visit_set_below(input_, granted.below, group, want.waiter,
                      [&](const Setter& by, const ConditionUse& entry) { look_at_entry(granted, want, by, entry); });
    }
  }

  /// The task, or one below it, ends the condition, and what causes it goes first, so that no task pushes it.
  void look_at_unpushed(ProviderId waiter, const ConditionUse& use) {
    const std::optional<RootCauser> causer = root_causers_.of(waiter, use.id);
    if (!causer) return;
    const Provider& row = model_.providers[waiter];
    const Want want{waiter, use, {causer->causer}};
    for (const ConditionUse& entry : row.sets) look_at_unpushed(want, *causer, setter_of(model_, waiter), entry, {});
    if (row.packs.empty()) return;
    const RunsBelow below(shared_.branches(), shared_.claims(row.group), row.group);
    for (const GroupId group : below.groups()) {
      if (group == row.group) continue;
      const std::vector<ChainStep> path = below.path(group);
      visit_set_below(input_, below, group, waiter, [&](const Setter& by, const ConditionUse& entry) {
        look_at_unpushed(want, *causer, by, entry, path);
      });
    }
  }

  /// The start of a task below ends the condition, and its stop brings it back, without a push. Of a task that is
  /// granted together with it, also the body may: undone_by_stop reports that of what the task requests itself.
  void look_at_rounds(const Granted& granted, ProviderId waiter) {
    const Region here = region_of(model_, model_.providers[waiter].when);
    for (const GroupId group : granted.below.groups()) {
      const Group& row = model_.groups[group];
      if (group == model_.providers[waiter].group || (granted.is_other() && row.requesters.size() > 1)) continue;
      if (row.start) look_at_rounds(granted, waiter, start_of(model_, group), row.start->sets);
      if (!granted.is_other()) continue;
      for (const ProviderId id : row.providers) {
        const Provider& provider = model_.providers[id];
        if (!facts_.active.contains(id) || !compatible(here, active_region(model_, provider))) continue;
        Setter by = setter_of(model_, id);
        look_at_rounds(granted, waiter, by, provider.sets);
        by.promised = true;
        look_at_rounds(granted, waiter, by, provider.causing);
      }
    }
  }

  std::vector<OwnUndoing> take() { return std::move(found_); }

private:
  void look_at_unpushed(const Want& want, const RootCauser& causer, const Setter& by, const ConditionUse& entry,
                        const std::vector<ChainStep>& path) {
    const ConditionUse& use = want.condition;
    if (model_.conditions[entry.id].state != model_.conditions[use.id].state) return;
    const ValueSet values = undoing_values(model_, want.waiter, use.id, model_.conditions[entry.id].accepts);
    if (values.empty() || !seen_.insert({entry.span, use.span}).second) return;
    OwnUndoing& found = add(want, by, entry, values);
    found.path = path;
    found.task = found.waits = model_.providers[want.waiter].group;
    found.back = OwnUndoing::Back::root;
    found.causer = causer.causer;
    found.root = causer.root;
  }

  void look_at_rounds(const Granted& granted, ProviderId waiter, const Setter& by,
                      const std::vector<ConditionUse>& entries) {
    for (const ConditionUse& entry : entries) {
      for (const ConditionUse& use : model_.providers[waiter].when)
        look_at_round(granted, {waiter, use, {}}, by, entry);
    }
  }

  void look_at_round(const Granted& granted, const Want& want, const Setter& by, const ConditionUse& entry) {
    const Condition& condition = model_.conditions[want.condition.id];
    if (model_.conditions[entry.id].state != condition.state || facts_.is_impossible(want.waiter, condition.state))
      return;
    const ValueSet values = undoing_values(model_, want.waiter, want.condition.id, model_.conditions[entry.id].accepts);
    if (values.empty()) return;
    const std::optional<dsl::Note> back = stop_that_causes(model_, by.group, want.condition.id);
    if (!back || !seen_.insert({entry.span, want.condition.span}).second) return;
    OwnUndoing& found = add(granted, want, by, entry, values);
    found.back = OwnUndoing::Back::stop;
    found.stop = back;
  }

  /// What the provider promises ends its task.
  void look_at_promise(const Granted& granted, const Want& want, const ConditionUse& entry) {
    if (!promises_.may_end(granted.task, want, entry)) return;
    Setter by = setter_of(model_, want.waiter);
    by.promised = true;
    look_at_entry(granted, want, by, entry);
  }

  void look_at_entry(const Granted& granted, const Want& want, const Setter& by, const ConditionUse& entry) {
    const Condition& set = model_.conditions[entry.id];
    if (set.state != model_.conditions[want.condition.id].state) return;
    // What it sets in its first run counts before what it requests there is granted.
    const bool at_first = !granted.is_other() && by.group == granted.task;
    const Timing timing = at_first ? Timing::with_grant : Timing::later;
    const ValueSet values = ending_values(model_, granted.waits, want, set.accepts, timing);
    if (values.empty()) return;
    auto causer = std::find_if(want.causers.begin(), want.causers.end(),
                               [&](ProviderId id) { return model_.providers[id].group != by.group; });
    if (causer == want.causers.end() && by.unpushed) causer = want.causers.begin();
    if (causer == want.causers.end() || !seen_.insert({entry.span, want.condition.span}).second) return;
    OwnUndoing& found = add(granted, want, by, entry, values);
    found.causer = *causer;
    found.timing = timing;
  }

  OwnUndoing& add(const Want& want, const Setter& by, const ConditionUse& entry, const ValueSet& values) {
    OwnUndoing& out = found_.emplace_back();
    out.want = want;
    out.by = by;
    out.entry = entry;
    out.values = values;
    return out;
  }

  OwnUndoing& add(const Granted& granted, const Want& want, const Setter& by, const ConditionUse& entry,
                  const ValueSet& values) {
    OwnUndoing& out = add(want, by, entry, values);
    out.path = granted.below.path(by.group);
    out.waits = granted.waits;
    out.task = granted.task;
    out.member = granted.member;
    return out;
  }

  const Input& input_;
  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  RootCausers root_causers_;
  const OwnPromises promises_;
  std::set<std::pair<dsl::Span, dsl::Span>> seen_; ///< entry and condition
  std::vector<OwnUndoing> found_;
};

} // namespace

std::vector<OwnUndoing> find_own_undoing(const Input& input) {
  OwnUndoingSearch search(input);
  for (const Wanting& wanting : input.shared.wants()) {
    for (const Granted& granted : granted_with(input, wanting)) {
      for (const Want& want : wanting.wants) search.look_at(granted, wanting.provider, want);
    }
  }
  for (const Wanting& wanting : input.shared.wants_of_pushed()) {
    Granted any = std::move(granted_with(input, wanting).front());
    for (const Granted& granted :
         with_each_pack(input.model, input.facts, input.shared, std::move(any), wanting.provider)) {
      for (const Want& want : wanting.wants) search.look_at(granted, wanting.provider, want);
    }
  }
  for (const ProviderId id : input.model.providers.ids()) {
    if (!input.facts.chosen.contains(id)) continue;
    for (const ConditionUse& use : input.model.providers[id].when) search.look_at_unpushed(id, use);
  }
  const IdTable<StateId, std::vector<GroupId>> stopping = find_stopping(input.model);
  for (const ProviderId id : input.model.providers.ids()) {
    const Provider& provider = input.model.providers[id];
    if (!input.facts.active.contains(id) ||
        std::none_of(provider.when.begin(), provider.when.end(),
                     [&](const ConditionUse& use) { return !stopping[input.model.conditions[use.id].state].empty(); }))
      continue;
    for (const Granted& granted : granted_with(input, provider.group)) search.look_at_rounds(granted, id);
  }
  return search.take();
}

} // namespace director::analysis
