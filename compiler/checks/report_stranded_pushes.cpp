// Header: compiler/checks/report_stranded_pushes.hpp. Test: compiler/checks/push_in_vain.md.
// SPDX-License-Identifier: MIT
#include "compiler/checks/report_stranded_pushes.hpp"

#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/clashes/holdings.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/facts/pushes.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace director::checks {

namespace {

/// What makes a condition of a pushed provider false that held when it was pushed.
struct Spoiler {
  ConditionUse use{};
  ProviderId waiter{}; ///< has the condition: the pushed provider, or one that it needs
  ValueSet values;     ///< with which it cannot continue
  ProviderId by{};
  dsl::Span span{};
};

class StrandedPushes {
public:
  StrandedPushes(const Input& input, Findings& findings)
      : model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        findings_(findings),
        sources_(find_sources(input.model)),
        pushes_(input.model, input.facts, shared_.chains(), shared_.causers()) {
    for (const Clash& clash : input.conflicts.clashes()) seen_.insert(clash.second.span);
  }

  void look_at(const Wanting& wanting) {
    std::optional<PushSearch> search;
    std::set<std::pair<ProviderId, ConditionId>> reported; // also where a need waits for the same
    for (const Want& want : wanting.wants) {
      if (seen_.count(want.condition.span) != 0) continue;
      for (const ProviderId pushed : want.causers) {
        const auto at = find_stranding(wanting, want, pushed, search);
        if (!at) continue;
        if (reported.emplace(pushed, at->use.id).second) report(wanting, want, pushed, *at);
        break;
      }
    }
  }

private:
  std::optional<Spoiler> find_stranding(const Wanting& wanting, const Want& want, ProviderId pushed,
                                        std::optional<PushSearch>& search) {
    for (const Spoiler& one : spoilers_of(pushed, want.condition.id)) {
      const GroupId group = model_.providers[one.by].group;
      if (group == wanting.task || shared_.chains().always_below(group, wanting.task) ||
          facts_.holds_always(model_, one.use.id, facts_.contexts[wanting.task]) || waits_too(wanting, one.use.id) ||
          excludes(wanting, one.use.id) || shared_.push_exclusion().excludes(want.waiter, one.by) ||
          !may_run_meanwhile(wanting, one.by) || !may_wait(wanting.task, want))
        continue;
      if (!search) search.emplace(pushes_, wanting.task);
      const std::vector<ProviderId>& causers = shared_.causers()[one.use.id];
      if (std::any_of(causers.begin(), causers.end(), [&](ProviderId causer) {
            return facts_.active.contains(causer) && model_.providers[causer].group != wanting.task &&
                   search->may_push_for(one.waiter, causer, one.use.id);
          }))
        return one;
    }
    return std::nullopt;
  }

  bool may_wait(GroupId task, const Want& want) const {
    const std::vector<Request>& requests = shared_.requests().of(task);
    return std::any_of(requests.begin(), requests.end(), [&](const Request& request) {
      return shared_.standstill().may_wait(request, want.waiter, want.condition);
    });
  }

  /// Whether the task, or what is granted only together with it, or always requested with it, pushes for the condition
  /// itself.
  bool waits_too(const Wanting& wanting, ConditionId id) {
    if (requires_it(wanting.provider, id)) return true;
    const std::vector<Request>& requests = shared_.requests().of(wanting.task);
    return std::any_of(requests.begin(), requests.end(), [&](const Request& request) {
      if (request.pack == nullptr) return false;
      const std::vector<Task>& beside = request.pack->tasks;
      if (std::any_of(beside.begin(), beside.end(), [&](const Task& each) { return pushes_for(each, id); }))
        return true;
      const std::vector<const Task*> unit = unit_of(request);
      return std::any_of(unit.begin(), unit.end(), [&](const Task* mate) {
        const std::vector<ProviderId>& all = model_.groups[mate->target].providers;
        return mate->target != wanting.task &&
               std::any_of(all.begin(), all.end(), [&](ProviderId each) { return requires_it(each, id); });
      });
    });
  }

  /// What may be granted only together with the task of the request, and that task; empty: it is a root task, or never
  /// a member of a unit.
  std::vector<const Task*> unit_of(const Request& request) const {
    if (request.pack == nullptr || !model_.may_be_member(*request.task)) return {};
    return unit_members(model_, *request.pack);
  }

  /// Whether the entry of a pack is always requested, and pushes for the condition.
  bool pushes_for(const Task& entry, ConditionId id) const {
    const std::vector<const Want*> wants = shared_.wants_of(entry.target);
    return !model_.may_be_left_out(entry) && std::any_of(wants.begin(), wants.end(), [&](const Want* want) {
      return !want->causers.empty() && model_.satisfies(want->condition.id, id);
    });
  }

  /// Whether the task runs only while the condition is false.
  bool excludes(const Wanting& wanting, ConditionId id) {
    const Condition& wanted = model_.conditions[id];
    const std::vector<std::pair<ProviderId, ConditionUse>>& all = conditions_of(wanting.provider);
    return std::any_of(all.begin(), all.end(), [&](const auto& each) {
      const Condition& other = model_.conditions[each.second.id];
      return other.state == wanted.state && !other.accepts.overlaps(wanted.accepts);
    });
  }

  bool requires_it(ProviderId id, ConditionId condition) {
    const std::vector<std::pair<ProviderId, ConditionUse>>& all = conditions_of(id);
    return std::any_of(all.begin(), all.end(),
                       [&](const auto& each) { return model_.satisfies(each.second.id, condition); });
  }

  /// Whether it is requested, and can have what it needs, while the task waits.
  bool may_run_meanwhile(const Wanting& wanting, ProviderId by) const {
    const GroupId group = model_.providers[by].group;
    const std::vector<Request>& of_task = shared_.requests().of(wanting.task);
    const std::vector<Request>& of_group = shared_.requests().of(group);
    const auto is_mate = [&](const Request& request) {
      const std::vector<const Task*> unit = unit_of(request);
      return std::any_of(unit.begin(), unit.end(), [&](const Task* mate) { return mate->target == wanting.task; });
    };
    return !std::all_of(of_group.begin(), of_group.end(), is_mate) &&
           std::any_of(of_task.begin(), of_task.end(), [&](const Request& request) {
             return !request.requester || find_kept_needs(model_, shared_, *request.requester, {by}).empty();
           });
  }

  /// Of the provider, and of the groups without alternative that it needs.
  const std::vector<std::pair<ProviderId, ConditionUse>>& conditions_of(ProviderId id) {
    const auto [at, is_new] = conditions_.try_emplace(id);
    if (!is_new) return at->second;
    std::vector<ProviderId> all = shared_.push_exclusion().needed(id);
    all.insert(all.begin(), id);
    for (const ProviderId each : all) {
      for (const ConditionUse& use : model_.providers[each].when) at->second.emplace_back(each, use);
    }
    return at->second;
  }

  /// Those whose value lasts, for each condition of what is pushed for the wanted one. Not each matters to each task.
  const std::vector<Spoiler>& spoilers_of(ProviderId pushed, ConditionId wanted) {
    const auto [at, is_new] = spoilers_.try_emplace({pushed, wanted});
    if (!is_new || shared_.promises().explained.contains(pushed)) return at->second;
    for (const auto& [waiter, use] : conditions_of(pushed)) {
      const StateId state = model_.conditions[use.id].state;
      if (facts_.is_impossible(waiter, state) || !values_set_by(model_, model_.providers[pushed], state).empty() ||
          waits_itself(pushed, use.id))
        continue;
      for (const Source& source : sources_[state]) {
        if (!source.provider || !may_spoil(pushed, *source.provider)) continue;
        const GroupId task = model_.providers[pushed].group;
        Want want{waiter, use, {}};
        if (waiter == pushed) want.pushed = {task, wanted}; // another one of its group has to cause that too
        const ValueSet values = undoing_values(model_, task, want, source.values);
        if (values.empty() || !holds_at_first(use.id, *source.provider) || comes_back(use.id, *source.provider))
          continue;
        at->second.push_back({use, waiter, values, *source.provider, source.span});
      }
    }
    return at->second;
  }

  /// Whether a task for the group of what is pushed waits for the condition, once it is lost, and pushes for it itself.
  bool waits_itself(ProviderId pushed, ConditionId id) const {
    const std::vector<const Want*> wants = shared_.wants_of(model_.providers[pushed].group);
    return std::any_of(wants.begin(), wants.end(), [&](const Want* want) { return want->condition.id == id; });
  }

  /// Whether it runs by itself, and can begin while the pushed one runs.
  bool may_spoil(ProviderId pushed, ProviderId by) const {
    const Provider& row = model_.providers[pushed];
    const Provider& other = model_.providers[by];
    const auto meets = [&](const Provider& one, const Provider& two) {
      return std::any_of(one.needs.begin(), one.needs.end(),
                         [&](const Use<GroupId>& need) { return shared_.indispensable().needs_part_of(two, need.id); });
    };
    return other.group != row.group && facts_.chosen.contains(by) &&
           compatible(region_of(model_, row.when), region_of(model_, other.when)) &&
           !leads_to(model_, shared_, pushed, other.group) && !meets(row, other) && !meets(other, row);
  }

  /// Whether it may be true without a push for it, as otherwise the push for it lasts too. What causes it by itself
  /// brings it back.
  bool holds_at_first(ConditionId id, ProviderId spoiler) const {
    const Condition& wanted = model_.conditions[id];
    return std::any_of(sources_[wanted.state].begin(), sources_[wanted.state].end(), [&](const Source& source) {
      return source.values.overlaps(wanted.accepts) &&
             (source.kind == Source::Kind::initial || is_handler_of(source, model_.providers[spoiler].group));
    });
  }

  /// While the group runs, it neither starts nor stops.
  static bool is_handler_of(const Source& source, GroupId group) { return source.group == group; }

  /// Whether something makes it true again while the spoiler runs, without a push.
  bool comes_back(ConditionId id, ProviderId spoiler) const {
    const Condition& wanted = model_.conditions[id];
    const State& state = model_.states[wanted.state];
    const GroupId group = model_.providers[spoiler].group;
    if (state.of && state.of->id != group && state.initial && wanted.accepts.contains(*state.initial)) return true;
    return std::any_of(sources_[wanted.state].begin(), sources_[wanted.state].end(), [&](const Source& source) {
      if (source.kind == Source::Kind::initial || !source.values.overlaps(wanted.accepts)) return false;
      if (!source.provider) return !is_handler_of(source, group);
      return source.kind == Source::Kind::sets ? facts_.active.contains(*source.provider)
                                               : facts_.chosen.contains(*source.provider);
    });
  }

  void report(const Wanting& wanting, const Want& want, ProviderId pushed, const Spoiler& one) {
    seen_.insert(want.condition.span);
    const std::string waiter = name_of(model_, want.waiter), by = name_of(model_, one.by);
    const std::string lost = name_of(model_, one.use.id), name = name_of(model_, pushed);
    dsl::Diagnostic& finding =
        findings_.add(want.condition.span, fmt::format("{} waits for {} in vain once {}, which it pushes, has lost {}: "
                                                       "the push is kept, and nothing is pushed for that condition",
                                                       waiter, name_of(model_, want.condition.id), name, lost));
    finding.notes.push_back(causes(model_, pushed, want.condition.id));
    const GroupId from = model_.providers[pushed].group, to = model_.providers[one.waiter].group;
    if (from != to) add_chain(model_, need_path(model_, from, to), finding.notes);
    finding.notes.push_back(runs_only_while(model_, one.waiter, one.use));
    const StateId state = model_.conditions[one.use.id].state;
    finding.notes.push_back({one.span, fmt::format("{} may set {} to {}", by, name_of(model_, state),
                                                   values_in_words(model_.states[state], one.values))});
    const std::string task = name_of(model_, wanting.provider);
    finding.help = undoes_itself(wanting, one)
                       ? fmt::format("let {} wait for {} too, and give it a `stay` without that", task, lost)
                       : fmt::format("let {} wait for {} too: then it pushes for that itself", task, lost);
  }

  /// Whether the task sets such a value once it runs, or what it requests then.
  bool undoes_itself(const Wanting& wanting, const Spoiler& one) const {
    const StateId state = model_.conditions[one.use.id].state;
    const Claims& claims = shared_.claims(wanting.task);
    return std::any_of(sources_[state].begin(), sources_[state].end(), [&](const Source& source) {
      return source.provider && source.values.overlaps(one.values) &&
             facts_.chosen.contains(*source.provider) &&
             (*source.provider == wanting.provider || (model_.providers[*source.provider].group != wanting.task &&
                                                       claims.contains(model_.providers[*source.provider].group)));
    });
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  Findings& findings_;
  IdTable<StateId, std::vector<Source>> sources_;
  Pushes pushes_;
  std::set<dsl::Span> seen_; ///< conditions with a finding
  std::map<ProviderId, std::vector<std::pair<ProviderId, ConditionUse>>> conditions_;
  std::map<std::pair<ProviderId, ConditionId>, std::vector<Spoiler>> spoilers_;
};

} // namespace

void report_stranded_pushes(const Input& input, Findings& findings) {
  StrandedPushes stranded(input, findings);
  for (const Wanting& wanting : input.shared.wants()) stranded.look_at(wanting);
}

} // namespace director::checks
