// Header: compiler/checks/check.hpp. Test: compiler/checks/uncovered_state.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/causing_cycles.hpp"
#include "compiler/analysis/causing/exclusion.hpp"
#include "compiler/analysis/causing/promises.hpp"
#include "compiler/analysis/causing/self_defeats.hpp"
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/chains/sparse_set.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/requests/earlier.hpp"
#include "compiler/analysis/requests/gaps.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

namespace director::checks {

namespace {

/// Limit for the combinations of values that are listed; further ones are counted.
constexpr std::size_t most_listed = 4;
/// ... up to this limit: a larger number tells the reader nothing more.
constexpr std::size_t most_gaps = 1'000;

class Uncovered {
public:
  Uncovered(const Input& input, Findings& findings)
      : model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        grants_(input.conflicts.grants()),
        earlier_(model_, facts_, shared_.requests(), shared_.rivals(), shared_.budget()),
        cycles_(model_, facts_, shared_.causers()),
        findings_(findings),
        explained_(input.shared.promises().explained) {
    for (const Imprecise& fault : shared_.imprecise()) explained_.add(fault.waiter);
    for (const Clash& clash : input.conflicts.clashes()) {
      explained_.add(clash.first_waiter);
      explained_.add(clash.second_waiter);
    }
    for (const SelfDefeat& fault : find_self_defeats(model_, facts_)) {
      if (!fault.stop) explained_.add(fault.provider);
    }
    for (const PackConflict& conflict : input.conflicts.pack_conflicts()) {
      if (!model_.providers[conflict.provider].has_packs || conflict.verdict != UnitVerdict::impossible) continue;
      for (const Task* member : conflict.members) conflicting_.insert(member);
      for (const Task* member : conflict.others) conflicting_.insert(member);
    }
    for (const Wanting& wanting : shared_.wants()) {
      for (const Want& want : wanting.wants) pushed_.insert({wanting.task, want.condition.id});
    }
    for (const Outranked& one : input.conflicts.outranked()) reported_.insert({one.request->target, one.condition.id});
    for (const HeldPush& held : input.conflicts.held_pushes()) reported_.insert({held.waits->target, held.wanted.id});
  }

  void run() {
    for (const GroupId group : model_.groups.ids()) {
      if (facts_.requested.contains(group) && (never_runs(group) || grants_.is_tried(group))) look_at(group);
    }
    report_all();
    for (const EdgeId edge : facts_.excluded_tasks) report_excluded(edge);
  }

private:
  struct Uncoveredness {
    GroupId group{};
    std::vector<std::string> gaps; ///< in words
    bool all = true;               ///< false: there are more than could be listed
    std::vector<Box> boxes;        ///< of each gap
    const Request* where = nullptr;
  };

  struct Gap {
    Box box;
    std::string words;
    const Request* where = nullptr;
  };

  /// Whether the first box is within the second one.
  bool lies_within(const Box& inner, const Box& outer) const {
    return std::all_of(outer.begin(), outer.end(), [&](const auto& entry) {
      const auto at = inner.find(entry.first);
      const Possible all{facts_.values[entry.first], model_.states[entry.first].may_be_unset()};
      const Possible& own = at == inner.end() ? all : at->second;
      return own.values.subset_of(entry.second.values) && (entry.second.unset || !own.unset);
    });
  }

  /// Keeps the larger of two gaps, if one is within the other.
  void add(Gap gap, std::vector<Gap>& gaps) const {
    if (std::any_of(gaps.begin(), gaps.end(), [&](const Gap& each) { return lies_within(gap.box, each.box); })) return;
    const auto is_inner = [&](const Gap& each) { return lies_within(each.box, gap.box); };
    gaps.erase(std::remove_if(gaps.begin(), gaps.end(), is_inner), gaps.end());
    gaps.push_back(std::move(gap));
  }

  /// Whether the condition is one that a task for this group has to wait for without being able to cause it.
  bool counts(GroupId group, ProviderId provider, const ConditionUse& use) const {
    if (explained_.contains(provider) || reported_.count({group, use.id}) != 0) return false;
    if (ends_requests(group, use)) return true;
    if (beginnings(group, provider, use)) return true;
    if (pushed_.count({group, use.id}) != 0) return false;
    const std::vector<ProviderId>& causers = shared_.causers()[use.id];
    return std::none_of(causers.begin(), causers.end(),
                        [&](ProviderId causer) { return may_cause(group, provider, causer); });
  }

  /// Whether no provider that requests the group runs while the condition holds: once it is caused, the request ends.
  bool ends_requests(GroupId group, const ConditionUse& use) const {
    const std::vector<Request>& requests = shared_.requests().of(group);
    return !requests.empty() && std::all_of(requests.begin(), requests.end(), [&](const Request& request) {
      return request.requester && !may_request_with(*request.requester, use);
    });
  }

  bool may_request_with(ProviderId requester, const ConditionUse& use) const {
    const Condition& condition = model_.conditions[use.id];
    const Region region = facts_.region_to_run(model_, requester, facts_.pushed.contains(requester));
    const auto at = region.states.find(condition.state);
    return at == region.states.end() || at->second.overlaps(condition.accepts);
  }

  bool may_cause(GroupId group, ProviderId provider, ProviderId causer) const {
    return model_.providers[causer].group != group && facts_.chosen.contains(causer) &&
           facts_.active.contains(causer) && !shared_.push_exclusion().find_outside(provider, causer);
  }

  /// Where a push can lead to the condition, if all that could cause it waits for it, itself or in a cycle.
  const std::optional<std::vector<Region>>& beginnings(GroupId group, ProviderId provider,
                                                       const ConditionUse& use) const {
    const auto [at, is_new] = beginnings_.try_emplace({group, provider, use.id});
    if (is_new)
      at->second = cycles_.beginnings(use.id, [&](ProviderId causer) { return may_cause(group, provider, causer); });
    return at->second;
  }

  /// Adds the ways to run by such a push.
  void add_cycles(GroupId group, std::vector<Region>& ways) const {
    for (const ProviderId id : model_.groups[group].providers) {
      for (const ConditionUse& use : model_.providers[id].when) {
        const std::optional<std::vector<Region>>& found = beginnings(group, id, use);
        if (!found || ends_requests(group, use)) continue;
        for (Region way : *found) {
          for (const ConditionUse& other : model_.providers[id].when) {
            if (other.id == use.id || !counts(group, id, other)) continue;
            way.meet(model_.conditions[other.id].state, model_.conditions[other.id].accepts);
          }
          if (!way.empty()) ways.push_back(std::move(way));
        }
      }
    }
  }

  /// Whether none of its providers ever runs, and no finding about one of them reports that.
  bool never_runs(GroupId group) const {
    const std::vector<ProviderId>& all = model_.groups[group].providers;
    return std::all_of(all.begin(), all.end(),
                       [&](ProviderId id) {
                         SparseSet<GroupId> seen;
                         return !facts_.active.contains(id) && !is_reported(id, seen);
                       }) &&
           !waits_with_reported(group);
  }

  /// Whether it could run, and all its requests are granted only together with what they exclude, which is reported.
  bool is_in_conflict(GroupId group) const {
    const std::vector<Request>& requests = shared_.requests().of(group);
    return facts_.capable_groups.contains(group) &&
           std::all_of(requests.begin(), requests.end(), [&](const Request& request) {
             return request.requester && conflicting_.count(request.task) != 0 &&
                    model_.is_always_member(*request.task);
           });
  }

  /// Whether all its requests are granted only together with something that never runs and is reported.
  bool waits_with_reported(GroupId group) const {
    bool any = false;
    for (const EdgeId edge : model_.groups[group].requesters) {
      if (model_.edges[edge].levels.empty()) continue;
      if (!model_.edges[edge].requester) return false;
      for (const ProviderId id : model_.groups[*model_.edges[edge].requester].providers) {
        if (!facts_.active.contains(id)) continue;
        for (const Pack& pack : model_.providers[id].packs) {
          const auto is_it = [&](const Task& task) { return task.target == group; };
          if (std::none_of(pack.tasks.begin(), pack.tasks.end(), is_it)) continue;
          if (!model_.providers[id].has_packs || !waits_with_reported(group, unit_members(model_, pack))) return false;
          any = true;
        }
      }
    }
    return any;
  }

  bool waits_with_reported(GroupId group, const std::vector<const Task*>& members) const {
    const auto is_it = [&](const Task* member) { return member->target == group; };
    return std::any_of(members.begin(), members.end(), is_it) &&
           std::any_of(members.begin(), members.end(), [&](const Task* member) {
             if (member->target == group || facts_.capable_groups.contains(member->target)) return false;
             const std::vector<ProviderId>& all = model_.groups[member->target].providers;
             return std::all_of(all.begin(), all.end(), [&](ProviderId each) {
               SparseSet<GroupId> seen;
               return is_reported(each, seen);
             });
           });
  }

  /// Whether another finding reports what prevents it, or what it needs, from running.
  bool is_reported(ProviderId id, SparseSet<GroupId>& seen) const {
    const auto faults = facts_.impossible_of(id);
    const std::vector<Use<GroupId>>& needs = model_.providers[id].needs;
    return explained_.contains(id) || facts_.plans[id] != PlanVerdict::found ||
           std::any_of(faults.begin(), faults.end(), [](const Impossible& fault) { return !fault.stay; }) ||
           std::any_of(needs.begin(), needs.end(), [&](const Use<GroupId>& need) {
             if (facts_.capable_groups.contains(need.id) || !seen.add(need.id)) return false;
             const std::vector<ProviderId>& below = model_.groups[need.id].providers;
             return std::any_of(below.begin(), below.end(), [&](ProviderId each) { return is_reported(each, seen); });
           });
  }

  Ways ways_for(GroupId task) const {
    return {model_, facts_, true,
            [this, task](ProviderId provider, const ConditionUse& use) { return counts(task, provider, use); }};
  }

  /// The parts of a gap in which the request may exist, although earlier providers of its requester go first where they
  /// can run. One of these that looks at no state of the gap is left out of the words: it matters only if nothing
  /// remains.
  std::vector<Box> open_parts(const Request& request, const Box& gap) const {
    if (!request.requester) return {gap};
    std::vector<Region> near;
    for (Region& each : earlier_.before(*request.requester, gap)) {
      const auto is_in_gap = [&](const auto& entry) {
        const auto at = gap.find(entry.first);
        return at != gap.end() &&
               at->second != Possible{facts_.values[entry.first], model_.states[entry.first].may_be_unset()};
      };
      if (std::any_of(each.states.begin(), each.states.end(), is_in_gap)) near.push_back(std::move(each));
    }
    Gaps parts{{gap}};
    if (!near.empty()) parts = find_gaps(model_, facts_, gap, near, shared_.budget());
    if (!parts.decided) parts.boxes = {gap};
    const auto is_closed = [&](const Box& part) { return !earlier_.may_exist(request, part); };
    parts.boxes.erase(std::remove_if(parts.boxes.begin(), parts.boxes.end(), is_closed), parts.boxes.end());
    return std::move(parts.boxes);
  }

  void look_at(GroupId group) {
    if (is_in_conflict(group)) return;
    std::vector<Region> open = ways_for(group).of(group);
    add_cycles(group, open);
    if (never_runs(group)) {
      const Request& first = shared_.requests().of(group).front();
      found_.push_back({group, {std::string(everywhere)}, true, {}, &first});
      return;
    }
    if (open.empty() || std::any_of(open.begin(), open.end(), [](const Region& way) { return way.states.empty(); }))
      return;
    std::vector<Gap> gaps;
    std::set<std::string> seen;
    bool all = true; // false: there are more than could be listed
    const auto look = [&](const Box& start, const Request& request) {
      const Gaps found = find_gaps(model_, facts_, start, open, shared_.budget());
      if (!found.decided)
        shared_.budget().leave_open(model_.groups[group].name.span,
                                    fmt::format("whether some provider of {} can always run", name_of(model_, group)));
      all = all && found.all;
      for (const Box& box : found.boxes) {
        for (const Box& part : open_parts(request, box)) {
          std::string words = gap_in_words(model_, facts_, part);
          if (seen.insert(words).second) add({part, std::move(words), &request}, gaps);
        }
      }
    };
    const std::vector<Request>& requests = shared_.requests().of(group);
    const bool is_root =
        std::any_of(requests.begin(), requests.end(), [](const Request& request) { return !request.requester; });
    for (const Request& request : requests) {
      if (is_root && request.requester) continue;
      for (const Region& region : shared_.requests().regions(request)) {
        all = all && gaps.size() < most_gaps;
        if (all || gaps.empty()) look(box_of(facts_.values, region), request);
      }
    }
    if (!gaps.empty()) found_.push_back(finding_for(group, gaps, all));
  }

  static Uncoveredness finding_for(GroupId group, const std::vector<Gap>& gaps, bool all) {
    Uncoveredness out{group, {}, all, {}, gaps.front().where};
    for (const Gap& gap : gaps) {
      out.gaps.push_back(gap.words);
      out.boxes.push_back(gap.box);
    }
    return out;
  }

  /// Reports several that wait for the same together, except those that may.
  void report_all() {
    std::map<std::pair<std::vector<std::string>, bool>, std::vector<const Uncoveredness*>> alike;
    std::vector<std::vector<const Uncoveredness*>> sets;
    for (const Uncoveredness& one : found_) {
      if (is_allowed(one.group)) {
        sets.push_back({&one});
      } else {
        alike[{one.gaps, one.all}].push_back(&one);
      }
    }
    for (auto& [what, all] : alike) sets.push_back(std::move(all));
    for (const auto& each : sets) report(each);
  }

  bool is_allowed(GroupId group) const {
    return std::any_of(model_.allowances.begin(), model_.allowances.end(), [&](const Allowance& allowance) {
      return allowance.id.value == "uncovered_state" && allowance.scope.contains(model_.groups[group].name.span);
    });
  }

  void report(const std::vector<const Uncoveredness*>& all) {
    std::vector<std::string> gaps = all.front()->gaps, names;
    for (const Uncoveredness* one : all) names.push_back(name_of(model_, one->group));
    const std::size_t more = gaps.size() > most_listed ? gaps.size() - most_listed : 0;
    gaps.resize(gaps.size() - more);
    if (!all.front()->all) {
      gaps.push_back("in many more cases");
    } else if (more > 0) {
      gaps.push_back(more == 1 ? "in one more case" : fmt::format("in {} more cases", more));
    }
    if (std::find(gaps.begin(), gaps.end(), everywhere) != gaps.end()) return report_never(all, few_of(names, "or"));
    dsl::Diagnostic& finding =
        findings_.add(model_.groups[all.front()->group].name.span,
                      fmt::format("no provider of {} can run {}", few_of(names, "or"), list_of(gaps, "or")));
    for (const Uncoveredness* one : all) add_notes(*one, one != all.front(), finding);
    finding.help = help_for_gap(all);
  }

  /// A task of the program may be requested at any time, whatever the program does. Another requester that has no
  /// provider without the request would itself be uncovered.
  std::string help_for_gap(const std::vector<const Uncoveredness*>& all) const {
    const bool by_program =
        std::any_of(all.begin(), all.end(), [](const Uncoveredness* one) { return !one->where->requester; });
    const bool one = all.size() == 1;
    if (const std::string stay = one ? help_for_ended(*all.front()) : std::string(); !stay.empty()) return stay;
    if (const std::string stay = one ? help_for_done(*all.front()) : std::string(); !stay.empty()) return stay;
    const std::string name = one ? name_of(model_, all.front()->group) : "them";
    const bool pushes =
        std::any_of(all.begin(), all.end(), [&](const Uncoveredness* each) { return depends_on_pushes(*each); });
    return (pushes ? "" : fmt::format("end {}with a provider that can always run, or ", one ? "" : "each ")) +
           (by_program ? fmt::format("allow this, if {} requested only while {} can run",
                                     one ? name + " is" : std::string("they are"), one ? "it" : "they")
                       : fmt::format("request {} only in providers that run while {} can, followed by one without that "
                                     "request",
                                     name, one ? "it" : "they"));
  }

  /// Whether only pushes bring about something that it waits for: if it could always run, it would push nothing.
  bool depends_on_pushes(const Uncoveredness& one) const {
    const std::vector<const Want*> wants = shared_.wants_of(one.group);
    return std::any_of(wants.begin(), wants.end(), [&](const Want* want) {
      return std::none_of(want->causers.begin(), want->causers.end(),
                          [&](ProviderId causer) { return facts_.chosen.contains(causer); });
    });
  }

  /// What is pushed for a condition of it ends its request.
  std::string help_for_ended(const Uncoveredness& one) const {
    for (const ProviderId id : model_.groups[one.group].providers) {
      for (const ConditionUse& use : model_.providers[id].when) {
        if (shared_.causers()[use.id].empty() || !counts(one.group, id, use) || !ends_requests(one.group, use))
          continue;
        const ProviderId requester = *one.where->requester;
        return fmt::format("{}, or do not request {} there",
                           stay_help(model_, {requester, use, {}}, model_.conditions[use.id].accepts),
                           name_of(model_, one.group));
      }
    }
    return {};
  }

  /// A provider of it sets what ends its own condition, and the requester looks at its done: that is lost if nothing
  /// runs then, and also if another provider begins.
  std::string help_for_done(const Uncoveredness& one) const {
    if (!one.where->requester) return {};
    const std::vector<Use<GroupId>>& uses = model_.providers[*one.where->requester].uses;
    if (std::none_of(uses.begin(), uses.end(), [&](const Use<GroupId>& use) { return use.id == one.group; })) return {};
    for (const ProviderId id : model_.groups[one.group].providers) {
      for (const ConditionUse& use : model_.providers[id].when) {
        const StateId state = model_.conditions[use.id].state;
        const ValueSet values = undoing_values(model_, id, use.id, values_set_by(model_, model_.providers[id], state));
        const bool ends = std::any_of(one.boxes.begin(), one.boxes.end(), [&](const Box& box) {
          const auto at = box.find(state);
          return at != box.end() && at->second.values.overlaps(values);
        });
        if (ends && counts(one.group, id, use) && !is_step(id, state, values))
          return fmt::format("{}: {} looks at its done, which is lost as soon as it cannot run",
                             stay_help(model_, {id, use, {}}, values), name_of(model_, *one.where->requester));
      }
    }
    return {};
  }

  /// Whether the value is one with which another provider of the group begins, which a `stay` would prevent.
  bool is_step(ProviderId id, StateId state, const ValueSet& values) const {
    const std::vector<ProviderId>& all = model_.group_of(id).providers;
    return std::any_of(all.begin(), all.end(), [&](ProviderId other) {
      const std::vector<ConditionUse>& when = model_.providers[other].when;
      return other != id && std::any_of(when.begin(), when.end(), [&](const ConditionUse& each) {
               const Condition& condition = model_.conditions[each.id];
               return condition.state == state && condition.accepts.overlaps(values);
             });
    });
  }

  /// With all values of the states.
  void report_never(const std::vector<const Uncoveredness*>& all, const std::string& names) {
    dsl::Diagnostic& finding = findings_.add(model_.groups[all.front()->group].name.span,
                                             fmt::format("no provider of {} can ever run", names));
    std::optional<Deadlock> deadlock;
    for (const Uncoveredness* one : all) {
      finding.rules_out.push_back(model_.groups[one->group].name.span);
      add_request(*one, one != all.front(), finding);
      Idleness idleness = explain_idle(model_, facts_, model_.groups[one->group].providers, one->where->task);
      if (!deadlock) deadlock = idleness.deadlock;
      add(std::move(idleness.notes), finding);
    }
    // If a provider lacks nothing that could be caused, conditions exclude each other.
    const bool excluded = std::all_of(all.begin(), all.end(), [&](const Uncoveredness* one) {
      const std::vector<ProviderId>& providers = model_.groups[one->group].providers;
      return std::all_of(providers.begin(), providers.end(),
                         [&](ProviderId id) { return !explain_exclusion(model_, facts_, id).empty(); });
    });
    // If a provider promised the state, that promise would be reported.
    finding.help = deadlock   ? apart_help(model_, *deadlock) + ", and promise what it waits for in `causing`"
                   : excluded ? "choose conditions that hold whenever it is requested"
                              : fmt::format("let something that is requested promise that in `causing`, or leave {} "
                                            "out",
                                            names);
  }

  /// It runs for others, but never for this requester.
  void report_excluded(EdgeId id) {
    const Edge& edge = model_.edges[id];
    for (const Request& request : shared_.requests().of(edge.target)) {
      if (!request.requester || request.task->edge != id) continue;
      const std::string name = name_of(model_, edge.target), by = name_of(model_, *edge.requester);
      dsl::Diagnostic& finding = findings_.add(
          request.task->span, fmt::format("{} never runs for {}, which requests it only where it cannot", name, by));
      finding.rules_out = {request.task->span};
      std::set<StateId> states;
      for (const ProviderId each : model_.groups[edge.target].providers) {
        for (const ConditionUse& use : model_.providers[each].when) states.insert(model_.conditions[use.id].state);
      }
      for (const GroupId group : {*edge.requester, edge.target}) {
        for (const ProviderId each : model_.groups[group].providers) {
          for (const ConditionUse& use : model_.providers[each].when) {
            if (states.count(model_.conditions[use.id].state) != 0)
              finding.notes.push_back(runs_only_while(model_, each, use));
          }
        }
      }
      finding.help = fmt::format("give {} a provider that can run there, or do not request it", name);
      return;
    }
  }

  void add_notes(const Uncoveredness& one, bool another, dsl::Diagnostic& finding) const {
    add_request(one, another, finding);
    Evidence evidence{one.group, one.boxes, ways_for(one.group), {}, {}, {}};
    for (const Box& box : one.boxes) {
      for (const auto& [state, possible] : box) evidence.states.insert(state);
    }
    add_conditions(one.group, evidence);
    add(std::move(evidence.notes), finding);
  }

  /// Few of one group, to leave room for the next one.
  static void add(std::vector<dsl::Note> notes, dsl::Diagnostic& finding) {
    shorten_list(notes);
    std::move(notes.begin(), notes.end(), std::back_inserter(finding.notes));
  }

  void add_request(const Uncoveredness& one, bool another, dsl::Diagnostic& finding) const {
    const std::string name = name_of(model_, one.group);
    if (another) finding.notes.push_back({model_.groups[one.group].name.span, fmt::format("nor can {}", name)});
    finding.notes.push_back(
        {one.where->task->span,
         one.where->requester
             ? fmt::format("{} requests {}", name_of(model_, *one.where->requester), another ? name : "it")
             : fmt::format("{} may be requested at any time", name)});
  }

  struct Evidence {
    GroupId task{};
    const std::vector<Box>& gaps;
    Ways ways;
    std::set<StateId> states; ///< of the gaps
    std::map<GroupId, bool> seen;
    std::vector<dsl::Note> notes;
  };

  /// Whether the group, or this need of another one, can run everywhere in the gaps: then it prevents nothing.
  bool runs_there(GroupId group, std::optional<GroupId> needer, Evidence& evidence) const {
    const std::vector<Region>& ways = needer ? evidence.ways.of_need(*needer, group) : evidence.ways.of(group);
    return std::all_of(evidence.gaps.begin(), evidence.gaps.end(), [&](const Box& gap) {
      return find_covering(model_, facts_.values, gap, ways, shared_.budget()) == Covering::covered;
    });
  }

  /// True if there is one in the group or below; each is noted once.
  bool add_conditions(GroupId group, Evidence& evidence, std::optional<GroupId> needer = {}) const {
    const auto [at, is_new] = evidence.seen.try_emplace(group, false);
    if (!is_new) return at->second;
    if (runs_there(group, needer, evidence)) return false;
    bool any = false;
    for (const ProviderId id : model_.groups[group].providers) {
      for (const ConditionUse& use : model_.providers[id].when) {
        if (evidence.states.count(model_.conditions[use.id].state) == 0 || !counts(evidence.task, id, use)) continue;
        any = true;
        evidence.notes.push_back(runs_only_while(model_, id, use));
        if (ends_requests(evidence.task, use)) {
          add_ending(evidence.task, use, evidence.notes);
        } else if (beginnings(evidence.task, id, use)) {
          add_waiting_causers(evidence.task, id, use, evidence.notes);
        }
      }
      for (const Use<GroupId>& need : model_.providers[id].needs) {
        if (!add_conditions(need.id, evidence, group)) continue;
        any = true;
        evidence.notes.push_back(
            {need.span, fmt::format("{} needs {}", name_of(model_, id), name_of(model_, need.id))});
      }
    }
    return evidence.seen[group] = any;
  }

  /// If something could be pushed for the condition.
  void add_ending(GroupId task, const ConditionUse& use, std::vector<dsl::Note>& notes) const {
    if (shared_.causers()[use.id].empty()) return;
    for (const Request& request : shared_.requests().of(task)) {
      for (const ConditionUse& each : model_.providers[*request.requester].when) {
        if (model_.conditions[each.id].state == model_.conditions[use.id].state)
          notes.push_back({each.span, fmt::format("{} ends the request of {} for {}", name_of(model_, use.id),
                                                  name_of(model_, *request.requester), name_of(model_, task))});
      }
    }
  }

  void add_waiting_causers(GroupId task, ProviderId provider, const ConditionUse& use,
                           std::vector<dsl::Note>& notes) const {
    for (const ProviderId causer : shared_.causers()[use.id]) {
      if (!may_cause(task, provider, causer)) continue;
      notes.push_back(causes(model_, causer, use.id));
      for (const ConditionUse& each : model_.providers[causer].when)
        notes.push_back(runs_only_while(model_, causer, each));
    }
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const Grants& grants_;
  const Earlier earlier_;
  const CausingCycles cycles_;
  mutable std::map<std::tuple<GroupId, ProviderId, ConditionId>, std::optional<std::vector<Region>>> beginnings_;
  Findings& findings_;
  IdSet<ProviderId> explained_;
  std::set<std::pair<GroupId, ConditionId>> pushed_;
  std::set<std::pair<GroupId, ConditionId>> reported_; ///< another finding says why it is not pushed
  std::set<const Task*> conflicting_;                  ///< entries of packs whose members exclude each other
  std::vector<Uncoveredness> found_;
};

} // namespace

void uncovered_state(const Input& input, Findings& findings) { Uncovered(input, findings).run(); }

} // namespace director::checks
