// Header: compiler/checks/check.hpp. Test: compiler/checks/undone_by_itself.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/chains/runs_below.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/requests/earlier.hpp"
#include "compiler/analysis/requests/gaps.hpp"
#include "compiler/analysis/rounds/granted.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace director::checks {

namespace {

class Undone {
public:
  Undone(const Input& input, Findings& findings)
      : model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        earlier_(model_, facts_, shared_.requests(), shared_.rivals(), shared_.budget()),
        findings_(findings) {}

  /// `provider`: of the task; it waits for its own conditions, and for those of what it needs.
  void look_at(const Granted& granted, ProviderId provider, const Want& want) {
    if (!granted.is_other()) {
      const Group& own = model_.groups[granted.task];
      const bool is_need = model_.providers[want.waiter].group != granted.task; // else self_defeating_handler
      if (own.start && is_need) {
        const Setter start{fmt::format("the start of {}", name_of(model_, granted.task)), granted.task};
        for (const ConditionUse& entry : own.start->sets) look_at_entry(granted, want, start, entry);
      }
      for (const ConditionUse& entry : model_.providers[provider].sets)
        look_at_entry(granted, want, setter(provider), entry);
      if (!want.pushed && want.waiter == provider) // else it is done then
        for (const ConditionUse& entry : model_.providers[provider].causing) look_at_goal(granted, want, entry);
    }
    for (const GroupId group : granted.below.groups()) {
      if (group != granted.waits) look_below(granted, want, group);
    }
  }

  /// The task, or one below it, ends the condition, and what causes it goes first, so that no task pushes it.
  void look_at_unpushed(const Input& input, ProviderId waiter, const ConditionUse& use) {
    if (!facts_.impossible_of(waiter).empty()) return;
    const auto [at, is_new] = only_causers_.try_emplace(use.id);
    if (is_new) at->second = find_only_causer(use.id);
    const std::optional<ProviderId> causer = at->second;
    if (!causer || !runs_once(*causer)) return;
    const Provider& row = model_.providers[waiter];
    const Task* const first = root_before(model_.providers[*causer].group, row.group);
    if (first == nullptr) return;
    const CausedByRoot wait{waiter, use, *causer, *first};
    for (const ConditionUse& entry : row.sets) look_at_unpushed(wait, setter(waiter), entry, {});
    if (row.packs.empty()) return;
    const RunsBelow below(input.shared.branches(), input.shared.claims(row.group), row.group);
    const Region here = region_of(model_, row.when);
    for (const GroupId group : below.groups()) {
      if (group == row.group) continue;
      const std::vector<ChainStep> path = below.path(group);
      if (model_.groups[group].start) {
        const Setter start{fmt::format("the start of {}", name_of(model_, group)), group};
        for (const ConditionUse& entry : model_.groups[group].start->sets) look_at_unpushed(wait, start, entry, path);
      }
      if (model_.groups[group].stop && may_be_dropped(path, group, waiter)) {
        const Setter stop{fmt::format("the stop of {}", name_of(model_, group)), group};
        for (const ConditionUse& entry : model_.groups[group].stop->sets) look_at_unpushed(wait, stop, entry, path);
      }
      for (const ProviderId id : model_.groups[group].providers) {
        const Provider& provider = model_.providers[id];
        if (!facts_.active.contains(id) || !compatible(here, active_region(model_, provider))) continue;
        Setter by = setter(id);
        for (const ConditionUse& entry : provider.sets) look_at_unpushed(wait, by, entry, path);
        by.promised = true;
        for (const ConditionUse& entry : provider.causing) look_at_unpushed(wait, by, entry, path);
      }
    }
  }

  /// The start of a task below ends the condition, and its stop brings it back, without a push. Of a task that is
  /// granted together with it, also the body may: undone_by_stop reports that of what the task requests itself.
  void look_at_rounds(const Granted& granted, ProviderId waiter) {
    const Region here = region_of(model_, model_.providers[waiter].when);
    for (const GroupId group : granted.below.groups()) {
      const Group& row = model_.groups[group];
      if (group == model_.providers[waiter].group || (granted.is_other() && row.requesters.size() > 1)) continue;
      if (row.start)
        look_at_rounds(granted, waiter, {fmt::format("the start of {}", name_of(model_, group)), group},
                       row.start->sets);
      if (!granted.is_other()) continue;
      for (const ProviderId id : row.providers) {
        const Provider& provider = model_.providers[id];
        if (!facts_.active.contains(id) || !compatible(here, active_region(model_, provider))) continue;
        Setter by = setter(id);
        look_at_rounds(granted, waiter, by, provider.sets);
        by.promised = true;
        look_at_rounds(granted, waiter, by, provider.causing);
      }
    }
  }

private:
  /// What may set the state.
  struct Setter {
    std::string name;
    GroupId group{};
    bool promised = false; ///< it causes it
    bool unpushed = false; ///< also if its own group causes the condition, which is no longer pushed once the task has
                           ///< that group
  };

  /// A condition that only a root causes that goes before the waiting one.
  struct CausedByRoot {
    ProviderId waiter{};
    const ConditionUse& use;
    ProviderId causer{};
    const Task& first;
  };

  void look_at_unpushed(const CausedByRoot& wait, const Setter& by, const ConditionUse& entry,
                        const std::vector<ChainStep>& path) {
    const auto& [waiter, use, causer, first] = wait;
    if (model_.conditions[entry.id].state != model_.conditions[use.id].state) return;
    const ValueSet values = undoing_values(model_, waiter, use.id, model_.conditions[entry.id].accepts);
    if (values.empty() || !seen_.insert({entry.span, use.span}).second) return;
    const std::string name = name_of(model_, waiter), causing = name_of(model_, causer);
    dsl::Diagnostic& finding = findings_.add(
        entry.span,
        fmt::format("{} may {} {}, and then {} is cut off, perhaps for ever: it cannot push {}, which causes {}",
                    by.name, by.promised ? "cause" : "set", name_of(model_, entry.id), name, causing,
                    name_of(model_, use.id)));
    finding.notes.push_back(runs_only_while(model_, waiter, use));
    add_chain(model_, path, finding.notes);
    finding.notes.push_back(causes(model_, causer, use.id));
    finding.notes.push_back(
        {first.span, fmt::format("{} goes before {}", name_of(model_, model_.providers[causer].group),
                                 name_of(model_, model_.providers[waiter].group))});
    finding.help = stay_help(model_, {waiter, use, {}}, values);
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
    dsl::Diagnostic& finding =
        findings_.add(entry.span, fmt::format("{} may {} {}, and then {} is cut off until {} stops: the two go round",
                                              by.name, by.promised ? "cause" : "set", name_of(model_, entry.id),
                                              name_of(model_, want.waiter), name_of(model_, by.group)));
    finding.notes.push_back(runs_only_while(model_, want.waiter, want.condition));
    add_company(granted, finding.notes);
    add_chain(model_, granted.below.path(by.group), finding.notes);
    finding.notes.push_back(*back);
    finding.help = stay_help(model_, want, values);
  }

  void add_company(const Granted& granted, std::vector<dsl::Note>& notes) const {
    if (!granted.is_other()) return;
    notes.push_back({granted.member->span, fmt::format("{} is granted together with {}", name_of(model_, granted.task),
                                                       name_of(model_, granted.waits))});
  }

  /// The provider that causes the condition, if nothing else can make it true after the start.
  std::optional<ProviderId> find_only_causer(ConditionId id) {
    const Condition& condition = model_.conditions[id];
    if (model_.states[condition.state].of) return std::nullopt; // it begins again
    if (!sources_) sources_ = find_sources(model_);
    std::optional<ProviderId> out;
    for (const Source& source : (*sources_)[condition.state]) {
      if (source.kind == Source::Kind::initial || !source.values.overlaps(condition.accepts)) continue;
      if (source.kind != Source::Kind::causing || (out && out != source.provider)) return std::nullopt;
      out = source.provider;
    }
    return out && model_.causes(*out, id) ? out : std::nullopt;
  }

  /// Whether it is chosen from the start, and runs again only if the body or a new task says so.
  bool runs_once(ProviderId id) const {
    const Provider& row = model_.providers[id];
    return facts_.chosen.contains(id) && model_.groups[row.group].providers.size() == 1 && row.when.empty() &&
           row.needs.empty() && row.packs.empty() && row.triggers.empty() && !row.every;
  }

  /// The root of the first group, if each is requested only as a root, and it goes before the other one.
  const Task* root_before(GroupId first, GroupId second) const {
    const auto root_of = [&](GroupId group) -> const Task* {
      const Group& row = model_.groups[group];
      if (!std::all_of(row.requesters.begin(), row.requesters.end(),
                       [&](EdgeId edge) { return !model_.edges[edge].requester; }))
        return nullptr;
      const auto at = std::find_if(model_.roots.begin(), model_.roots.end(),
                                   [&](const Task& root) { return root.target == group; });
      return at == model_.roots.end() ? nullptr : &*at;
    };
    const Task *a = root_of(first), *b = root_of(second);
    return a != nullptr && b != nullptr && goes_before(*a, *b) ? a : nullptr;
  }

  /// At every level of both.
  bool goes_before(const Task& first, const Task& second) const {
    const auto& firsts = model_.edges[first.edge].levels;
    const auto& seconds = model_.edges[second.edge].levels;
    return std::all_of(firsts.begin(), firsts.end(), [&](const Level& a) {
      return std::all_of(seconds.begin(), seconds.end(), [&](const Level& b) {
        return a.optional == b.optional ? a.priority > b.priority : b.optional;
      });
    });
  }

  /// What the provider promises ends its task, where the request ends too: the program's does. While it is pushed, its
  /// condition does not count.
  void look_at_goal(const Granted& granted, const Want& want, const ConditionUse& entry) {
    const Condition& promise = model_.conditions[entry.id];
    if (promise.state != model_.conditions[want.condition.id].state) return;
    const ValueSet values = undoing_values(model_, want.waiter, want.condition.id, promise.accepts);
    const std::vector<Request>& requests = shared_.requests().of(granted.task);
    const auto lasts = [&](const Request& request) {
      if (!request.requester || !ends_unpushed(granted.task, want, *request.task)) return false;
      const std::vector<Region> regions = shared_.requests().regions(request);
      return std::any_of(regions.begin(), regions.end(), [&](const Region& region) {
        Box box = box_of(facts_.values, region);
        Possible& here = possible_in(model_, facts_, promise.state, box);
        here = {here.values.intersected(values), false};
        return !here.empty() && earlier_.may_exist(request, box);
      });
    };
    if (values.empty() || std::none_of(requests.begin(), requests.end(), lasts)) return;
    Setter by = setter(want.waiter);
    by.promised = true;
    look_at_entry(granted, want, by, entry);
  }

  /// Whether at this request nothing pushes the provider, and it pushes one of those that cause its condition.
  bool ends_unpushed(GroupId task, const Want& want, const Task& request) const {
    const bool pushes = std::any_of(want.causers.begin(), want.causers.end(), [&](ProviderId id) {
      return goes_before_at(task, model_.providers[id].group, request, &Meeting::first);
    });
    if (!pushes || !facts_.pushed.contains(want.waiter)) return pushes;
    if (!pushers_) pushers_ = find_pushers();
    const auto known = pushers_->find(want.waiter);
    return known != pushers_->end() && std::none_of(known->second.begin(), known->second.end(), [&](GroupId pusher) {
             return goes_before_at(pusher, task, request, &Meeting::second);
           });
  }

  /// Whether the one goes before the other where this request of one of them, or what leads to it, meets the other.
  bool goes_before_at(GroupId first, GroupId second, const Task& request, const Task* Meeting::*side) const {
    bool out = false;
    shared_.chains().visit(first, {second}, [&](const Meeting& meeting, GroupId) {
      const Task* entry = meeting.*side;
      out = out || (!meeting.one_unit() && meeting.first_goes_before() &&
                    (entry == &request || entry->target != request.target));
    });
    return out;
  }

  /// The tasks that may push a provider, for what they wait for themselves or for another push.
  std::map<ProviderId, std::set<GroupId>> find_pushers() const {
    std::map<ProviderId, std::set<GroupId>> out;
    for (const std::vector<Wanting>* all : {&shared_.wants(), &shared_.wants_of_pushed()}) {
      for (const Wanting& wanting : *all) {
        for (const Want& want : wanting.wants) {
          for (const ProviderId id : want.causers) out[id].insert(want.pushed ? want.pushed->by : wanting.task);
        }
      }
    }
    return out;
  }

  /// Whether the group may stop while the task goes on above it: something on the path may run without the next group,
  /// with another pack or provider, or with the same one if that is `optional` or `apart`.
  bool may_be_dropped(const std::vector<ChainStep>& path, GroupId group, ProviderId waiter) const {
    const Region here = region_of(model_, model_.providers[waiter].when);
    return std::any_of(path.begin(), path.end(), [&](const ChainStep& step) {
      bool leads = false, does_without = false;
      for (const ProviderId id : model_.groups[step.from].providers) {
        const Provider& row = model_.providers[id];
        const bool goes_on = step.from == model_.providers[waiter].group
                                 ? id == waiter
                                 : facts_.active.contains(id) && compatible(here, active_region(model_, row));
        if (!goes_on) continue;
        does_without = does_without || row.packs.empty();
        for (const Pack& pack : row.packs) {
          bool keeps = false;
          for (const Task& task : pack.tasks) {
            if (!shared_.claims(task.target).contains(group)) continue;
            leads = true;
            keeps = keeps || ((!pack.name.empty() || pack.tasks.size() == 1) && model_.is_always_member(task));
          }
          does_without = does_without || !keeps;
        }
      }
      return leads && does_without;
    });
  }

  Setter setter(ProviderId id) const { return {name_of(model_, id), model_.providers[id].group}; }

  void look_below(const Granted& granted, const Want& want, GroupId group) {
    Region here = region_of(model_, model_.providers[want.waiter].when);
    if (model_.groups[group].start) {
      const Setter start{fmt::format("the start of {}", name_of(model_, group)), group};
      for (const ConditionUse& entry : model_.groups[group].start->sets) look_at_entry(granted, want, start, entry);
    }
    if (model_.groups[group].stop && may_be_dropped(granted.below.path(group), group, want.waiter)) {
      const Setter stop{fmt::format("the stop of {}", name_of(model_, group)), group};
      for (const ConditionUse& entry : model_.groups[group].stop->sets) look_at_entry(granted, want, stop, entry);
    }
    bool comes_first = true; // no earlier one is always chosen
    for (const ProviderId id : model_.groups[group].providers) {
      const Provider& provider = model_.providers[id];
      if (!facts_.active.contains(id) || !compatible(here, active_region(model_, provider))) continue;
      Setter by = setter(id);
      by.unpushed = comes_first;
      for (const ConditionUse& entry : provider.sets) look_at_entry(granted, want, by, entry);
      by.promised = true;
      for (const ConditionUse& entry : provider.causing) look_at_entry(granted, want, by, entry);
      if (contains(region_of(model_, provider.when), here)) comes_first = false;
    }
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
    const std::string waiter = name_of(model_, want.waiter), condition = name_of(model_, want.condition.id);
    dsl::Diagnostic& finding =
        findings_.add(entry.span, fmt::format("{} may {} {}, and then {} is cut off until {} causes {} again", by.name,
                                              by.promised ? "cause" : "set", name_of(model_, entry.id), waiter,
                                              name_of(model_, *causer), condition));
    add_waiter(model_, want, finding.notes);
    add_chain(model_, need_path(model_, granted.waits, model_.providers[want.waiter].group), finding.notes);
    add_company(granted, finding.notes);
    add_chain(model_, granted.below.path(by.group), finding.notes);
    finding.notes.push_back(causes(model_, *causer, want.condition.id));
    finding.help = stay_help(model_, granted.waits, want, values, timing);
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const Earlier earlier_;
  Findings& findings_;
  std::set<std::pair<dsl::Span, dsl::Span>> seen_;
  std::optional<IdTable<StateId, std::vector<Source>>> sources_;
  std::map<ConditionId, std::optional<ProviderId>> only_causers_;
  mutable std::optional<std::map<ProviderId, std::set<GroupId>>> pushers_;
};

/// The states to which the stop of some group gives a value.
IdSet<StateId> states_of_stops(const Model& model) {
  IdSet<StateId> out(model.states.size());
  for (const StateId id : model.states.ids()) {
    if (model.states[id].of) out.add(id);
  }
  for (const Group& group : model.groups) {
    if (!group.stop) continue;
    for (const ConditionUse& entry : group.stop->sets) out.add(model.conditions[entry.id].state);
  }
  return out;
}

} // namespace

void undone_by_itself(const Input& input, Findings& findings) {
  Undone undone(input, findings);
  for (const Wanting& wanting : input.shared.wants()) {
    for (const Granted& granted : granted_with(input, wanting)) {
      for (const Want& want : wanting.wants) undone.look_at(granted, wanting.provider, want);
    }
  }
  for (const Wanting& wanting : input.shared.wants_of_pushed()) {
    Granted any = std::move(granted_with(input, wanting).front());
    for (const Granted& granted :
         with_each_pack(input.model, input.facts, input.shared, std::move(any), wanting.provider)) {
      for (const Want& want : wanting.wants) undone.look_at(granted, wanting.provider, want);
    }
  }
  for (const ProviderId id : input.model.providers.ids()) {
    if (!input.facts.chosen.contains(id)) continue;
    for (const ConditionUse& use : input.model.providers[id].when) undone.look_at_unpushed(input, id, use);
  }
  const IdSet<StateId> by_stops = states_of_stops(input.model);
  for (const ProviderId id : input.model.providers.ids()) {
    const compiler::Provider& provider = input.model.providers[id];
    if (!input.facts.active.contains(id) ||
        std::none_of(provider.when.begin(), provider.when.end(),
                     [&](const ConditionUse& use) { return by_stops.contains(input.model.conditions[use.id].state); }))
      continue;
    for (const Granted& granted : granted_with(input, provider.group)) undone.look_at_rounds(granted, id);
  }
}

} // namespace director::checks
