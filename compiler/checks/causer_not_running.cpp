// Header: compiler/checks/check.hpp. Test: compiler/checks/causer_not_running.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/clashes/holdings.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/requests/company.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/stopped_values.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/proposals.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

namespace director::checks {

namespace {

class Loneliness {
public:
  Loneliness(const Input& input, Findings& findings)
      : model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        outranked_(input.conflicts.outranked()),
        findings_(findings) {
    for (const Clash& clash : input.conflicts.clashes()) {
      if (clash.kind == Clash::Kind::vain) in_vain_.insert({clash.second_waiter, clash.second.id});
    }
  }

  void run() {
    for (const ProviderId waiter : model_.providers.ids()) {
      if (!facts_.requested.contains(model_.providers[waiter].group)) continue;
      for (const ConditionUse& use : model_.providers[waiter].when) look_at(waiter, use);
    }
  }

private:
  void look_at(ProviderId waiter, const ConditionUse& use) {
    if (in_vain_.count({waiter, use.id}) != 0) return;
    const GroupId task = model_.providers[waiter].group;
    std::vector<ProviderId> causers;
    std::vector<GroupId> groups;
    for (const ProviderId id : shared_.causers()[use.id]) {
      const GroupId group = model_.providers[id].group;
      // What never runs for another reason is reported by another check.
      if (group == task || !facts_.capable.contains(id)) continue;
      if (shared_.promises().explained.contains(id)) return;
      causers.push_back(id);
      groups.push_back(group);
    }
    if (causers.empty()) return;
    const bool is_root = std::any_of(model_.roots.begin(), model_.roots.end(), [&](const Task& root) {
      return std::find(groups.begin(), groups.end(), root.target) != groups.end();
    });
    if (is_root) return;
    std::set<const Task*> reported;
    for (const Request& request : shared_.requests().of(task)) {
      if (!request.requester || is_claimed_above(request) ||
          !shared_.standstill().may_wait(request, waiter, use, groups))
        continue;
      Company company(model_, facts_, shared_.requests(), groups);
      const std::vector<const Task*> chain = company.find_bare_chain(request);
      if (chain.empty()) continue;
      const std::vector<Request> above = find_waiting_above(request, chain, task);
      const Request& place = above.empty() ? request : above.back();
      if (!reported.insert(place.task).second) continue;
      const auto begin = chain.begin() + static_cast<std::ptrdiff_t>(above.size());
      report(waiter, use, causers, place, {begin, chain.end()}, company.held_back());
    }
  }

  /// Of the chain above the request, the entries of those that need the task: they wait with it, and request nothing.
  std::vector<Request> find_waiting_above(const Request& request, const std::vector<const Task*>& chain,
                                          GroupId task) const {
    std::vector<Request> out;
    const Request* last = &request;
    while (shared_.indispensable().needs_contain(model_.providers[*last->requester], task)) {
      const std::vector<Request>& all = shared_.requests().of(model_.providers[*last->requester].group);
      const auto at = std::find_if(all.begin(), all.end(), [&](const Request& each) {
        return each.requester && each.task == chain[out.size() + 1];
      });
      if (at == all.end()) break;
      last = &*at;
      out.push_back(*at);
    }
    return out;
  }

  /// Whether the program requests what needs the task.
  bool waits_with_root(const Request& request, const std::vector<const Task*>& chain, GroupId task) const {
    return chain.size() == 2 && shared_.indispensable().needs_contain(model_.providers[*request.requester], task);
  }

  /// A need keeps the causing group from being pushed, requested or not.
  bool is_claimed_above(const Request& request) const {
    return std::any_of(outranked_.begin(), outranked_.end(),
                       [&](const Outranked& one) { return one.request == request.task && one.need != nullptr; });
  }

  void report(ProviderId waiter, const ConditionUse& use, const std::vector<ProviderId>& causers,
              const Request& request, const std::vector<const Task*>& chain, const std::set<const Task*>& held_back) {
    const ProviderId causer = find_nearest(causers, request, held_back);
    const std::string group = name_of(model_, model_.providers[causer].group);
    dsl::Diagnostic& finding = findings_.add(
        request.task->span, fmt::format("{} may wait here for {}, and {}, which could cause it, need not be requested",
                                        name_of(model_, request.task->target), name_of(model_, use.id), group));
    finding.rules_out = {use.span};
    finding.notes.push_back({use.span, fmt::format("{} waits for this", name_of(model_, waiter))});
    for (const ProviderId id : causers) finding.notes.push_back(causes(model_, id, use.id));
    const GroupId waiting = model_.providers[waiter].group;
    add_chain(model_, need_path(model_, request.task->target, waiting), finding.notes);
    for (const GroupId each : groups_of(causers)) {
      if (const Span own = request_span(model_, waiting, each); own != Span{})
        finding.notes.push_back({own, fmt::format("{} requests {} itself, but only once it runs",
                                                  name_of(model_, waiting), name_of(model_, each))});
    }
    for (std::size_t i = 1; i < chain.size(); ++i)
      finding.notes.push_back(
          {chain[i]->span, fmt::format("{} is requested here, without {}", name_of(model_, chain[i]->target), group)});
    for (const Task& task : request.pack->tasks) {
      if (held_back.count(&task) == 0) continue;
      std::vector<std::string> brought;
      for (const GroupId each : groups_of(causers)) {
        if (leads_to(task, each)) brought.push_back(name_of(model_, each));
      }
      finding.notes.push_back({task.span, fmt::format("{} would request {}, but is granted only together with {}",
                                                      name_of(model_, task.target), list_of(brought, "or"),
                                                      name_of(model_, request.task->target))});
    }
    if (const ConditionUse* step = find_own_step(model_, waiter); step != nullptr && step->id != use.id) {
      const State& own = model_.states[model_.conditions[step->id].state];
      finding.help = fmt::format("let {} request a group that waits for {} instead: while {} waits, {} is {} again",
                                 name_of(model_, waiter), name_of(model_, use.id), name_of(model_, waiting),
                                 name_of(model_, model_.conditions[step->id].state), own.value_text(*own.initial));
      return;
    }
    const bool by_program =
        leads_back(model_.providers[causer].group, chain) || waits_with_root(request, chain, waiting);
    finding.help = !held_back.empty() ? set_apart(request, held_back)
                   : by_program       ? fmt::format("let the program request {} too, with a lower priority", group)
                                      : propose_company(request, causer, waiting);
    add_kept(*request.requester, causers, causer, finding);
    for (const ConditionUse& promise : model_.providers[waiter].causing) {
      const Condition& goal = model_.conditions[promise.id];
      if (goal.state != model_.conditions[use.id].state) continue;
      // Otherwise it is pushed again when it is done (undone_by_itself).
      if (const ValueSet values = undoing_values(model_, waiter, use.id, goal.accepts); !values.empty())
        finding.help += ", and " + stay_help(model_, {waiter, use, {}}, values);
    }
    add_excluded(waiter, use, request, causer, finding);
    if (held_back.empty()) finding.help += ": a push never starts a group";
  }

  std::string propose_company(const Request& request, ProviderId causer, GroupId waiting) const {
    const std::string group = name_of(model_, model_.providers[causer].group);
    const bool flat = request.pack->name.empty(), optional = model_.may_be_left_out(*request.task);
    // What is mandatory goes before what is optional, with any priority.
    const std::string rank = optional                                  ? ", `optional` and with a lower priority"
                             : !flat || must_be_apart(request, causer) ? ", `apart` and with a lower priority"
                                                                       : "";
    if (flat) return fmt::format("say with `packs` that {} is requested too{}", group, rank);
    const bool may_be_above = !optional && !would_be_stopped(model_.providers[causer].group, waiting);
    return fmt::format("request {} too, here{}{}", group, may_be_above ? " or above" : "", rank);
  }

  /// Requested there, it could not run either.
  void add_kept(ProviderId requester, const std::vector<ProviderId>& causers, ProviderId causer,
                dsl::Diagnostic& finding) const {
    const std::vector<KeptNeed> kept = find_kept_needs(model_, shared_, requester, causers);
    if (kept.empty()) return;
    const auto at = std::find(causers.begin(), causers.end(), causer) - causers.begin();
    const KeptNeed& one = kept[static_cast<std::size_t>(at)];
    finding.notes.push_back(one.needed);
    finding.notes.push_back(one.kept);
    finding.help += fmt::format(", and let {} or {} do without {}", name_of(model_, causer), name_of(model_, requester),
                                name_of(model_, one.group));
  }

  /// Nor could it run, requested there, with the values of a state that only the outside changes.
  void add_excluded(ProviderId waiter, const ConditionUse& use, const Request& request, ProviderId causer,
                    dsl::Diagnostic& finding) const {
    const PushExclusion& exclusion = shared_.push_exclusion();
    std::optional<StateId> state;
    ValueSet values;
    for (const Region& region : shared_.requests().regions(request)) {
      const auto here = exclusion.find_outside(waiter, region, causer, Region{});
      if (!here || (state && here != state)) return;
      state = here;
      values = values.united(exclusion.values_of(*here, waiter, region));
    }
    if (!state) return;
    add_exclusion(model_, exclusion, *state, waiter, causer, finding.notes);
    add_exclusion(model_, exclusion, *state, *request.requester, causer, finding.notes);
    finding.help += fmt::format(", and {}", propose_causer(model_, *state, values, use.id));
  }

  /// Whether it would not pass to an entry above the waiting task at once, as that task may take what it has to have
  /// (hard_hand_over).
  bool would_be_stopped(GroupId causer, GroupId waiting) const {
    const auto& parts = shared_.indispensable().of(causer);
    return parts && std::any_of(parts->begin(), parts->end(),
                                [&](GroupId part) { return part != causer && shared_.claims(waiting).contains(part); });
  }

  /// The one that an entry that is held back would request, or else the first.
  ProviderId find_nearest(const std::vector<ProviderId>& causers, const Request& request,
                          const std::set<const Task*>& held_back) const {
    for (const Task& task : request.pack->tasks) {
      if (held_back.count(&task) == 0) continue;
      for (const ProviderId id : causers) {
        if (leads_to(task, model_.providers[id].group)) return id;
      }
    }
    return causers.front();
  }

  /// Whether the entry's group requests that one, or something that does.
  bool leads_to(const Task& entry, GroupId group) const {
    std::vector<GroupId> above{group};
    std::set<GroupId> seen{group};
    for (std::size_t next = 0; next < above.size(); ++next) {
      for (const Request& request : shared_.requests().of(above[next])) {
        if (!request.requester) continue;
        const GroupId requester = model_.providers[*request.requester].group;
        if (requester == entry.target) return true;
        if (seen.insert(requester).second) above.push_back(requester);
      }
    }
    return false;
  }

  /// Each once.
  std::vector<GroupId> groups_of(const std::vector<ProviderId>& causers) const {
    std::vector<GroupId> out;
    for (const ProviderId id : causers) {
      const GroupId group = model_.providers[id].group;
      if (std::find(out.begin(), out.end(), group) == out.end()) out.push_back(group);
    }
    return out;
  }

  /// Whether its own requests lead to a group that might request it: it would wait for itself.
  bool leads_back(GroupId causer, const std::vector<const Task*>& chain) const {
    const Claims& below = shared_.claims(causer);
    return std::any_of(chain.begin() + 1, chain.end(),
                       [&](const Task* above) { return below.contains(above->target); });
  }

  /// Otherwise it would go after what it has to push.
  std::string set_apart(const Request& request, const std::set<const Task*>& held_back) const {
    const auto priority = [&](const Task& task) {
      return model_.edges[task.edge].levels[task.levels.front().level].priority;
    };
    const std::string apart = fmt::format("make {} `apart`", name_of(model_, request.task->target));
    std::vector<std::string> before;
    for (const Task& task : request.pack->tasks) {
      if (held_back.count(&task) != 0 && priority(task) >= priority(*request.task))
        before.push_back(name_of(model_, task.target));
    }
    return before.empty() ? apart + ", so that it waits for itself alone"
                          : fmt::format("{}, with a higher priority than {}", apart, list_of(before));
  }

  /// In a pack it would be granted only together with what waits, as the pack has no separate entry yet.
  bool must_be_apart(const Request& request, ProviderId causer) const {
    const std::vector<Task>& tasks = request.pack->tasks;
    return model_.is_always_member(*request.task) && std::none_of(tasks.begin(), tasks.end(), [&](const Task& entry) {
             return entry.target == model_.providers[causer].group && !model_.is_always_member(entry);
           });
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const std::vector<Outranked>& outranked_;
  Findings& findings_;
  std::set<std::pair<ProviderId, ConditionId>> in_vain_;
};

} // namespace

void causer_not_running(const Input& input, Findings& findings) { Loneliness(input, findings).run(); }

} // namespace director::checks
