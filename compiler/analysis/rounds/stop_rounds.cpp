// Header: compiler/analysis/rounds/stop_rounds.hpp. Test: compiler/checks/undone_by_stop.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/rounds/stop_rounds.hpp"

#include "compiler/analysis/rounds/spoiling.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/words/notes.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace director::analysis {

namespace {

class StopRounds {
public:
  StopRounds(const Input& input, const IdTable<StateId, std::vector<GroupId>>& stopping,
             const std::vector<EndedRequests>& ended)
      : input_(input),
        model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        settings_(input),
        stopping_(stopping) {
    for (const EndedRequests& each : ended) ended_.insert({each.group, each.state});
  }

  /// What is caused by a push.
  void look_at(const Wanting& wanting) {
    std::vector<Granted> granted;
    std::vector<Spoiling> spoiling;
    for (const Want& want : wanting.wants) {
      const StateId state = model_.conditions[want.condition.id].state;
      if (stopping_[state].empty()) continue;
      if (granted.empty()) {
        granted = find_granted(wanting);
        for (const Granted& each : granted) spoiling.emplace_back(model_, facts_, each, wanting.provider);
      }
      for (std::size_t i = 0; i < granted.size(); ++i) look_at(granted[i], spoiling[i], want, state);
    }
  }

  /// What a group that goes after the task sets without a push.
  void look_at_unpushed(ProviderId waiter) {
    const GroupId task = model_.providers[waiter].group;
    if (!settings_.may_undo(waiter)) return;
    std::optional<Granted> granted;
    for (const ConditionUse& use : model_.providers[waiter].when) {
      const StateId state = model_.conditions[use.id].state;
      for (const GroupId stopped : stopping_[state]) {
        if (stopped == task) continue;
        if (!granted) granted.emplace(granted_alone(model_, shared_, task));
        if (!takes_from(granted->takings, stopped) || settings_.is_kept_off(waiter, stopped)) continue;
        for (const StopValue& stop : stop_values(model_, stopped, state)) {
          std::optional<Setting> setting = settings_.find_start(waiter, use, stopped, stop.values);
          if (!setting) setting = settings_.find_setting(waiter, use, stopped, stop.values);
          if (!setting || !shared_.chains().may_beat(task, stopped)) continue;
          look_at_stop(*granted, {waiter, use, {}}, *setting, stopped, stop, {});
        }
      }
    }
  }

  std::vector<StopRound> take() { return std::move(found_); }

private:
  /// With each pack of the task.
  std::vector<Granted> find_granted(const Wanting& wanting) const {
    std::vector<Granted> out;
    for (Granted& any : granted_with(input_, wanting)) {
      for (Granted& each : with_each_pack(model_, facts_, shared_, std::move(any), wanting.provider))
        out.push_back(std::move(each));
    }
    return out;
  }

  void look_at(const Granted& granted, const Spoiling& spoiling, const Want& want, StateId state) {
    for (const ProviderId id : want.causers) {
      const Setting causer{id, causes(model_, id, want.condition.id)};
      for (const GroupId stopped : stopping_[state]) {
        if (stopped == model_.providers[id].group) {
          look_at_stops(granted, want, causer, stopped, state, {});
          look_at_spoilt(granted, spoiling, want, causer, state);
        } else
          look_below(granted, want, causer, stopped, state);
        look_beside(granted, want, causer, stopped, state);
      }
    }
  }

  void look_below(const Granted& granted, const Want& want, const Setting& causer, GroupId stopped, StateId state) {
    const std::vector<ChainStep> chain = way_below(model_, shared_, causer.provider, stopped);
    if (!chain.empty()) look_at_stops(granted, want, causer, stopped, state, chain);
  }

  /// A group that has nothing to do with the causing one, runs again when the task has lost control, and loses what it
  /// needs again when the task is granted. Of several such tasks the first is found; what is pushed is not
  /// considered.
  void look_beside(const Granted& granted, const Want& want, const Setting& causer, GroupId stopped, StateId state) {
    const GroupId causing = model_.providers[causer.provider].group;
    if (granted.is_other() || granted.pushed || beside_.count({stopped, state}) != 0 ||
        !takes_from(granted.takings, stopped) ||
        (!granted.takings.takes(stopped) &&
         !why_needs_fail(model_, facts_, granted.takings, stopped, causer.provider)) ||
        !is_beside(granted.task, causing, stopped))
      return;
    const Takings before(model_, shared_.indispensable(), shared_.claims(causing), causing);
    if (takes_from(before, stopped)) return; // it has stopped before, because of the push
    for (const StopValue& stop : stop_values(model_, stopped, state)) {
      const ValueSet values = stop.values.without(model_.conditions[want.condition.id].accepts);
      if (!values.empty() && runs_until_granted(want, causer.provider, stopped, state, values) &&
          look_at_stop(granted, want, causer, stopped, stop, {}))
        beside_.insert({stopped, state});
    }
  }

  /// Whether they are requested together and by themselves, and the task goes before the other group.
  bool is_beside(GroupId task, GroupId causing, GroupId stopped) const {
    if (stopped == task || stopped == causing || !facts_.requested.contains(stopped)) return false;
    const Claims& of_stopped = shared_.claims(stopped);
    if (of_stopped.contains(task) || of_stopped.contains(causing) || shared_.claims(causing).contains(stopped))
      return false;
    bool out = false;
    shared_.chains().visit(task, {stopped}, [&](const Meeting& meeting, GroupId) {
      out = out || (meeting.first->target == task && !meeting.one_unit() && meeting.first_goes_before());
    });
    return out;
  }

  /// Whether a provider of the group may be chosen while the state has one of these values, and still run when the
  /// condition has been caused.
  bool runs_until_granted(const Want& want, ProviderId causer, GroupId group, StateId state,
                          const ValueSet& values) const {
    const Region here = region_of(model_, model_.providers[want.waiter].when);
    Region before = here;
    before.states[state] = values;
    const Region pushed = active_region(model_, model_.providers[causer]);
    const std::vector<ProviderId>& all = model_.groups[group].providers;
    return std::any_of(all.begin(), all.end(), [&](ProviderId id) {
      const Region own = active_region(model_, model_.providers[id]);
      return facts_.chosen.contains(id) && compatible(region_of(model_, model_.providers[id].when), before) &&
             compatible(own, here) && compatible(own, pushed);
    });
  }

  /// `chain`: from the causing group to the one that stops; empty: that is the causing group itself.
  void look_at_stops(const Granted& granted, const Want& want, const Setting& causer, GroupId stopped, StateId state,
                     const std::vector<ChainStep>& chain) {
    for (const StopValue& stop : stop_values(model_, stopped, state))
      look_at_stop(granted, want, causer, stopped, stop, chain);
  }

  /// Where the causing group stops because each of its providers loses a condition.
  void look_at_spoilt(const Granted& granted, const Spoiling& spoiling, const Want& want, const Setting& causer,
                      StateId state) {
    const GroupId stopped = model_.providers[causer.provider].group;
    if (granted.below.contains(stopped) || granted.takings.takes(stopped)) return;
    const std::optional<Spoilt> spoilt = spoiling.of(causer.provider, want.condition.id);
    const std::vector<ProviderId>& all = model_.groups[stopped].providers;
    if (!spoilt || !std::all_of(all.begin(), all.end(), [&](ProviderId id) {
          return !facts_.active.contains(id) || spoiling.of(id, want.condition.id);
        }))
      return;
    for (const StopValue& stop : stop_values(model_, stopped, state)) {
      const ValueSet values = ending_values(model_, granted.waits, want, stop.values);
      if (values.empty() || seen_.count({stop.span, want.condition.span}) != 0) continue;
      StopReason reason{{spoilt->notes, {}}};
      reason.how.notes.insert(reason.how.notes.begin(), runs_only_while(model_, causer.provider, spoilt->condition));
      add(granted, want, causer, stop, values, Timing::later, std::move(reason));
    }
  }

  /// Whether it is found now.
  bool look_at_stop(const Granted& granted, const Want& want, const Setting& causer, GroupId stopped,
                    const StopValue& stop, const std::vector<ChainStep>& chain) {
    const auto undoing = [&](Timing timing) { return ending_values(model_, granted.waits, want, stop.values, timing); };
    if (undoing(Timing::with_grant).empty() || seen_.count({stop.span, want.condition.span}) != 0 ||
        ended_.count({stopped, model_.conditions[want.condition.id].state}) != 0)
      return false;
    std::optional<StopReason> reason = why_stopped(input_, granted, stopped, causer.provider);
    if (!reason) return false;
    Taking& how = reason->how;
    // What the task needs it takes as it is granted; what it requests, as it runs.
    const Timing timing = how.requests.empty() ? Timing::with_grant : Timing::later;
    const ValueSet values = undoing(timing);
    if (values.empty()) return false;
    std::vector<dsl::Note> notes;
    add_chain(model_, chain, notes);
    const auto is_reported = [&](const dsl::Note& note) {
      return std::any_of(notes.begin(), notes.end(), [&](const dsl::Note& told) { return told.span == note.span; });
    };
    how.notes.erase(std::remove_if(how.notes.begin(), how.notes.end(), is_reported), how.notes.end());
    how.notes.insert(how.notes.begin(), notes.begin(), notes.end());
    add(granted, want, causer, stop, values, timing, std::move(*reason));
    return true;
  }

  /// Whether the group, or a need of it, is taken. Few are, of all that may set one state.
  bool takes_from(const Takings& takings, GroupId group) const {
    const std::vector<ProviderId>& all = model_.groups[group].providers;
    return takings.takes(group) ||
           std::any_of(all.begin(), all.end(), [&](ProviderId id) { return takings.need_taken(id) != nullptr; });
  }

  void add(const Granted& granted, const Want& want, const Setting& causer, const StopValue& stop, ValueSet values,
           Timing timing, StopReason reason) {
    seen_.insert({stop.span, want.condition.span});
    found_.push_back(
        {granted.waits, is_granted(model_, granted), want, causer, stop, std::move(values), timing, std::move(reason)});
  }

  const Input& input_;
  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const Settings settings_;
  const IdTable<StateId, std::vector<GroupId>>& stopping_;
  std::set<std::pair<GroupId, StateId>> ended_;    ///< of groups that end the requests for themselves
  std::set<std::pair<GroupId, StateId>> beside_;   ///< found, of groups beside the two
  std::set<std::pair<dsl::Span, dsl::Span>> seen_; ///< stop and condition
  std::vector<StopRound> found_;
};

} // namespace

std::vector<StopRound> find_stop_rounds(const Input& input, const IdTable<StateId, std::vector<GroupId>>& stopping,
                                        const std::vector<EndedRequests>& ended) {
  StopRounds rounds(input, stopping, ended);
  for (const Wanting& wanting : input.shared.wants()) rounds.look_at(wanting);
  for (const Wanting& wanting : input.shared.wants_of_pushed()) rounds.look_at(wanting);
  for (const ProviderId id : input.model.providers.ids()) {
    if (input.facts.chosen.contains(id)) rounds.look_at_unpushed(id);
  }
  return rounds.take();
}

} // namespace director::analysis
