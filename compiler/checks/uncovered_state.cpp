// Header: compiler/checks/check.hpp. Test: compiler/checks/uncovered_state.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/exclusion.hpp"
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/uncovered/uncovered.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace director::checks {

namespace {

/// Limit for the combinations of values that are listed; further ones are counted.
constexpr std::size_t most_listed = 4;

class UncoveredReport {
public:
  UncoveredReport(const Input& input, Findings& findings)
      : model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        unserved_(input),
        found_(find_uncovered(input, unserved_)),
        findings_(findings) {}

  void run() {
    report_all();
    for (const EdgeId edge : facts_.excluded_tasks) report_excluded(edge);
  }

private:
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
        if (shared_.causers()[use.id].empty() || !unserved_.counts(one.group, id, use) ||
            !unserved_.ends_requests(one.group, use))
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
        if (ends && unserved_.counts(one.group, id, use) && !is_step(id, state, values))
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
    Evidence evidence{one.group, one.boxes, unserved_.ways_for(one.group), {}, {}, {}};
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
        if (evidence.states.count(model_.conditions[use.id].state) == 0 || !unserved_.counts(evidence.task, id, use))
          continue;
        any = true;
        evidence.notes.push_back(runs_only_while(model_, id, use));
        if (unserved_.ends_requests(evidence.task, use)) {
          add_ending(evidence.task, use, evidence.notes);
        } else if (unserved_.beginnings(evidence.task, id, use)) {
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
      if (!unserved_.may_cause(task, provider, causer)) continue;
      notes.push_back(causes(model_, causer, use.id));
      for (const ConditionUse& each : model_.providers[causer].when)
        notes.push_back(runs_only_while(model_, causer, each));
    }
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const Unserved unserved_;
  const std::vector<Uncoveredness> found_;
  Findings& findings_;
};

} // namespace

void uncovered_state(const Input& input, Findings& findings) { UncoveredReport(input, findings).run(); }

} // namespace director::checks
