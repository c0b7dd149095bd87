// Header: compiler/checks/check.hpp. Test: compiler/checks/undone_by_stop.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/rounds/granted.hpp"
#include "compiler/analysis/rounds/settings.hpp"
#include "compiler/analysis/rounds/spoiling.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

namespace director::checks {

namespace {

class UndoneByStop {
public:
  UndoneByStop(const Input& input, Findings& findings)
      : input_(input),
        model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        settings_(input),
        findings_(findings),
        stopping_(input.model.states.size()) {
    for (const GroupId group : model_.groups.ids()) {
      if (!model_.groups[group].stop) continue;
      for (const ConditionUse& entry : model_.groups[group].stop->sets)
        add_stopping(model_.conditions[entry.id].state, group);
    }
    for (const StateId state : model_.states.ids()) {
      if (model_.states[state].of) add_stopping(state, model_.states[state].of->id);
    }
  }

  /// What a group sets, or causes, ends all requests for it.
  void look_at_requests() {
    for (const StateId state : model_.states.ids()) {
      for (const GroupId group : stopping_[state]) {
        for (const ProviderId id : model_.groups[group].providers) {
          if (facts_.active.contains(id)) look_at_requests(group, state, id);
        }
      }
    }
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

private:
  void look_at_requests(GroupId group, StateId state, ProviderId id) {
    const Provider& row = model_.providers[id];
    for (const std::vector<ConditionUse>* entries : {&row.causing, &row.sets}) {
      for (const ConditionUse& entry : *entries) {
        const Condition& set = model_.conditions[entry.id];
        if (set.state != state) continue;
        for (const StopValue& stop : stop_values(model_, group, state)) {
          const std::optional<Ended> ended = find_ended(group, state, set.accepts, stop.values);
          if (ended && ends_.insert({group, state}).second) report(*ended, id, entry, entries == &row.causing, stop);
        }
      }
    }
  }

  struct Ended {
    ProviderId requester{};
    ProviderId waits{}; ///< it, or one that it needs, which cannot run with what is set
  };

  /// The first provider that requests the group and begins again with a value of its stop, if the values that the group
  /// sets end all that request it.
  std::optional<Ended> find_ended(GroupId group, StateId state, const ValueSet& set, const ValueSet& stop) const {
    const auto accepts_any = [&](const Region& region, const ValueSet& values) {
      const auto at = region.states.find(state);
      return at == region.states.end() || at->second.overlaps(values);
    };
    std::optional<Ended> out;
    for (const Request& request : shared_.requests().of(group)) {
      if (!request.requester) return std::nullopt;
      const ProviderId requester = *request.requester;
      std::vector<ProviderId> all = shared_.push_exclusion().needed(requester);
      all.insert(all.begin(), requester);
      const auto waits = std::find_if(all.begin(), all.end(), [&](ProviderId id) {
        if (id == requester) return !accepts_any(facts_.region_to_run(model_, id, facts_.pushed.contains(id)), set);
        const bool runs = is_granted_with(model_, model_.providers[requester].group, {id, {}, {}});
        const Provider& row = model_.providers[id];
        return !accepts_any(runs ? active_region(model_, row) : region_of(model_, row.when), set);
      });
      if (waits == all.end()) return std::nullopt;
      const bool begins = std::all_of(all.begin(), all.end(), [&](ProviderId id) {
        return accepts_any(region_of(model_, model_.providers[id].when), stop);
      });
      if (!out && facts_.chosen.contains(requester) && begins) out = {requester, *waits};
    }
    return out;
  }

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

  void add_stopping(StateId state, GroupId group) {
    std::vector<GroupId>& groups = stopping_[state];
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  }

  void look_below(const Granted& granted, const Want& want, const Setting& causer, GroupId stopped, StateId state) {
    const std::vector<ChainStep> chain = way_below(model_, shared_, causer.provider, stopped);
    if (!chain.empty()) look_at_stops(granted, want, causer, stopped, state, chain);
  }

  /// A group that has nothing to do with the causing one, runs again when the task has lost control, and loses what it
  /// needs again when the task is granted. Of several such tasks the first is reported; what is pushed is not
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
      Taking how{spoilt->notes, {}};
      how.notes.insert(how.notes.begin(), runs_only_while(model_, causer.provider, spoilt->condition));
      report(granted, want, causer, stop, values, std::move(how), Timing::later);
    }
  }

  /// Whether it is reported now.
  bool look_at_stop(const Granted& granted, const Want& want, const Setting& causer, GroupId stopped,
                    const StopValue& stop, const std::vector<ChainStep>& chain) {
    const auto undoing = [&](Timing timing) { return ending_values(model_, granted.waits, want, stop.values, timing); };
    if (undoing(Timing::with_grant).empty() || seen_.count({stop.span, want.condition.span}) != 0 ||
        ends_.count({stopped, model_.conditions[want.condition.id].state}) != 0)
      return false;
    Search search{causer.provider, {}, {}, {}};
    std::optional<Taking> how = why_stopped(granted, stopped, search);
    if (!how) return false;
    // What the task needs it takes as it is granted; what it requests, as it runs.
    const Timing timing = how->requests.empty() ? Timing::with_grant : Timing::later;
    const ValueSet values = undoing(timing);
    if (values.empty()) return false;
    std::vector<dsl::Note> notes;
    add_chain(model_, chain, notes);
    const auto is_reported = [&](const dsl::Note& note) {
      return std::any_of(notes.begin(), notes.end(), [&](const dsl::Note& told) { return told.span == note.span; });
    };
    how->notes.erase(std::remove_if(how->notes.begin(), how->notes.end(), is_reported), how->notes.end());
    how->notes.insert(how->notes.begin(), notes.begin(), notes.end());
    report(granted, want, causer, stop, values, std::move(*how), timing,
           search.refused.size() == 1 ? search.refused.front() : nullptr);
    return true;
  }

  /// Whether the group, or a need of it, is taken. Few are, of all that may set one state.
  bool takes_from(const Takings& takings, GroupId group) const {
    const std::vector<ProviderId>& all = model_.groups[group].providers;
    return takings.takes(group) ||
           std::any_of(all.begin(), all.end(), [&](ProviderId id) { return takings.need_taken(id) != nullptr; });
  }

  struct Search {
    ProviderId causer{};
    std::set<GroupId> seen;           ///< groups whose requesters were looked at
    std::set<GroupId> stopped;        ///< of these, the ones that are known to stop
    std::vector<const Task*> refused; ///< requests whose unit is blocked, though their provider goes on
  };

  /// Empty: the group continues, or is handed over, or it is not certain.
  std::optional<Taking> why_stopped(const Granted& granted, GroupId group, Search& search) const {
    if (granted.below.contains(group)) return std::nullopt;
    if (granted.is_other() && shared_.claims(granted.waits).contains(group)) return std::nullopt;
    if (!is_requested_beside(shared_, granted, group)) return std::nullopt;
    // It is held only as a need then, and a group that is not requested stops.
    if (granted.takings.takes(group)) return granted.takings.way_to(group);
    if (std::optional<Taking> out = why_needs_fail(model_, facts_, granted.takings, group, search.causer)) return out;
    return why_unrequested(granted, group, search);
  }

  /// How everything that requests the group is stopped, and with it the group, described for the first one.
  std::optional<Taking> why_unrequested(const Granted& granted, GroupId group, Search& search) const {
    if (search.stopped.count(group) != 0) return Taking{}; // it is described already
    if (!search.seen.insert(group).second) return std::nullopt;
    std::optional<Taking> out;
    for (const EdgeId id : model_.groups[group].requesters) {
      const Edge& edge = model_.edges[id];
      if (edge.levels.empty()) continue;
      if (!edge.requester) return std::nullopt;
      if (!may_request(*edge.requester, group)) continue;
      std::optional<Taking> why = why_requester_stopped(granted, *edge.requester, search);
      const bool stops = why.has_value();
      if (!why) why = why_units_end(granted, id, search);
      if (!why) return std::nullopt;
      if (out) continue;
      out = std::move(why);
      if (!stops) continue; // the requester goes on
      const std::vector<ChainStep> step{{*edge.requester, group, false, request_span(model_, *edge.requester, group)}};
      std::vector<dsl::Note> notes;
      add_chain(model_, step, notes);
      out->notes.insert(out->notes.begin(), notes.begin(), notes.end());
    }
    if (out) search.stopped.insert(group);
    return out;
  }

  /// How each unit in which the requester of this edge requests it is blocked, described for the first one.
  std::optional<Taking> why_units_end(const Granted& granted, EdgeId edge, Search& search) const {
    std::optional<Taking> out;
    for (const Request& request : shared_.requests().of(model_.edges[edge].target)) {
      if (request.task->edge != edge) continue;
      std::optional<Taking> why = why_unit_ends(model_, facts_, shared_, granted, request, search.causer);
      if (!why) return std::nullopt;
      search.refused.push_back(request.task);
      if (!out) out = std::move(why);
    }
    return out;
  }

  std::optional<Taking> why_requester_stopped(const Granted& granted, GroupId requester, Search& search) const {
    // The task does not stop what leads to it, or what goes before it.
    if (shared_.claims(requester).contains(granted.task)) return std::nullopt;
    if (!granted.takings.may_beat(requester)) return std::nullopt;
    return why_stopped(granted, requester, search);
  }

  bool may_request(GroupId from, GroupId to) const {
    const std::vector<Branch>& branches = shared_.branches().from(from);
    return facts_.requested.contains(from) && std::any_of(branches.begin(), branches.end(), [&](const Branch& branch) {
             return branch.to == to && !branch.by_need;
           });
  }

  /// `refused`: it would go on if this request were `apart`.
  void report(const Granted& granted, const Want& want, const Setting& causer, const StopValue& stop,
              const ValueSet& values, Taking how, Timing timing, const Task* refused = nullptr) {
    seen_.insert({stop.span, want.condition.span});
    dsl::Diagnostic& finding = findings_.add(
        stop.span, fmt::format("{}, and it is stopped when {}, which waits for {}: the two go round", stop.what,
                               is_granted(model_, granted), name_of(model_, want.condition.id)));
    add_taking(model_, want, causer.note, std::move(how), finding);
    finding.help = refused == nullptr ? "" : fmt::format("make {} `apart`, or ", name_of(model_, refused->target));
    finding.help += stay_help(model_, granted.waits, want, values, timing);
  }

  void report(const Ended& ended, ProviderId setter, const ConditionUse& entry, bool promised, const StopValue& stop) {
    const Condition& set = model_.conditions[entry.id];
    const GroupId group = model_.providers[setter].group;
    const std::string condition = name_of(model_, entry.id), requester = name_of(model_, ended.requester);
    dsl::Diagnostic& finding = findings_.add(
        stop.span, fmt::format("{}, and it is stopped when it has {} {}, which ends {}, which requests it: the two go "
                               "round",
                               stop.what, promised ? "caused" : "set", condition, requester));
    finding.notes.push_back(
        {entry.span, fmt::format("{} {} {}", name_of(model_, setter), promised ? "causes" : "may set", condition)});
    for (const compiler::Provider& provider : model_.providers) {
      for (const ConditionUse& each : provider.when) {
        const Condition& waits = model_.conditions[each.id];
        if (waits.state == set.state && waits.accepts.overlaps(set.accepts) &&
            !waits.accepts.overlaps(stop.values))
          finding.rules_out.push_back(each.span);
      }
    }
    const std::vector<ConditionUse>& when = model_.providers[ended.waits].when;
    const auto use = std::find_if(when.begin(), when.end(), [&](const ConditionUse& each) {
      return model_.conditions[each.id].state == set.state;
    });
    if (use != when.end()) finding.notes.push_back(runs_only_while(model_, ended.waits, *use));
    const GroupId of = model_.providers[ended.requester].group;
    add_chain(model_, need_path(model_, of, model_.providers[ended.waits].group), finding.notes);
    if (const RequestEntry request = find_entry(model_, ended.requester, group); request.task != nullptr)
      finding.notes.push_back(requests(model_, ended.requester, *request.task));
    if (const std::optional<ProviderId> next = find_next(ended.requester, set)) {
      finding.help = fmt::format("{}: {} can run with {}", stop.without, name_of(model_, *next), condition);
    } else {
      finding.help = use == when.end() ? "" : stay_help(model_, of, {ended.waits, *use, {}}, set.accepts) + ", or ";
      finding.help += stop.without;
    }
  }

  /// Another provider of the group that may run then: with a `stay` it would not.
  std::optional<ProviderId> find_next(ProviderId ended, const Condition& set) const {
    for (const ProviderId id : model_.group_of(ended).providers) {
      if (id == ended || !facts_.active.contains(id)) continue;
      const Region region = facts_.region_to_run(model_, id, facts_.pushed.contains(id));
      const auto at = region.states.find(set.state);
      if (at == region.states.end() || at->second.overlaps(set.accepts)) return id;
    }
    return std::nullopt;
  }

  const Input& input_;
  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const Settings settings_;
  Findings& findings_;
  IdTable<StateId, std::vector<GroupId>> stopping_; ///< groups whose stop may set it
  std::set<std::pair<dsl::Span, dsl::Span>> seen_;
  std::set<std::pair<GroupId, StateId>> ends_;   ///< reported, of what such a group sets itself
  std::set<std::pair<GroupId, StateId>> beside_; ///< reported, of groups beside the two
};

} // namespace

void undone_by_stop(const Input& input, Findings& findings) {
  UndoneByStop undone(input, findings);
  undone.look_at_requests();
  for (const Wanting& wanting : input.shared.wants()) undone.look_at(wanting);
  for (const Wanting& wanting : input.shared.wants_of_pushed()) undone.look_at(wanting);
  for (const ProviderId id : input.model.providers.ids()) {
    if (input.facts.chosen.contains(id)) undone.look_at_unpushed(id);
  }
}

} // namespace director::checks
