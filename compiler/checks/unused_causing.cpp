// Header: compiler/checks/check.hpp. Test: compiler/checks/unused_causing.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/clashes/pushers.hpp"
#include "compiler/analysis/facts/waiting.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/proposals.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace director::checks {

namespace {

/// Whether a task that needs the group can never have it by this provider, which needs what the task or another of its
/// needs holds: so it may have to wait for another one.
bool is_no_choice_for_need(const Input& input, ProviderId id) {
  const Provider& provider = input.model.providers[id];
  const Indispensable& parts = input.shared.indispensable();
  const auto clashes = [&](const Provider& needer, GroupId need) {
    return parts.contains(need, needer.group) ||
           std::any_of(needer.needs.begin(), needer.needs.end(), [&](const Use<GroupId>& other) {
             return other.id != provider.group && !parts.in_common(need, other.id).empty();
           });
  };
  return std::any_of(input.model.providers.begin(), input.model.providers.end(), [&](const Provider& needer) {
    return needer.group != provider.group && needer.needs_group(provider.group) &&
           std::any_of(provider.needs.begin(), provider.needs.end(),
                       [&](const Use<GroupId>& need) { return clashes(needer, need.id); });
  });
}

/// A state of which a task that waits for the promise requires other values than this provider, so that it never pushes
/// it.
std::optional<StateId> find_exclusion(const Input& input, Waiting& waiting, const Graph::Causing& arrow) {
  const GroupId task = input.model.providers[arrow.waiter].group;
  if (!input.facts.requested.contains(task) || !waiting.may_wait(task) || !waiting.may_be_first(arrow.waiter) ||
      !input.shared.chains().may_beat(task, input.model.providers[arrow.causer].group))
    return std::nullopt;
  return input.shared.push_exclusion().find(arrow.waiter, arrow.causer);
}

/// Whether another provider causes it, which the task may push.
bool has_another(const Input& input, const Graph::Causing& arrow) {
  const std::vector<ProviderId>& causers = input.shared.causers()[arrow.condition.id];
  return std::any_of(causers.begin(), causers.end(), [&](ProviderId other) {
    return other != arrow.causer && input.facts.active.contains(other) &&
           !input.shared.push_exclusion().excludes(arrow.waiter, other);
  });
}

/// Sets the help, and notes the providers that listen to the broken promise, which is never reported.
void advise(const Input& input, ProviderId id, const ConditionUse& promise, dsl::Diagnostic& finding) {
  const Model& model = input.model;
  finding.help = "values that a provider sets without a promise belong in `sets`";
  if (!promise.within) return;
  for (const Provider& listener : model.providers) {
    for (const Use<TriggerId>& use : listener.triggers) {
      const Trigger& trigger = model.triggers[use.id];
      if (trigger.promise != id) continue;
      finding.notes.push_back({use.span, fmt::format("{} listens to `{}`, which never fires for this",
                                                     name_of(model, listener.group), trigger.name)});
    }
  }
}

/// Those of other groups with a condition that it satisfies.
std::vector<const Graph::Causing*> find_waiters(const Input& input, ProviderId id, const ConditionUse& promise) {
  std::vector<const Graph::Causing*> out;
  for (const Graph::Causing& arrow : input.graph.causing) {
    if (arrow.causer == id && arrow.promise.span == promise.span &&
        input.model.providers[arrow.waiter].group != input.model.providers[id].group)
      out.push_back(&arrow);
  }
  return out;
}

/// No group with the condition ever pushes for it: it holds, or another provider of theirs can run, or they go after
/// this group.
void report_unpushed(const Input& input, Pushers& pushers, ProviderId causer, const ConditionUse& promise,
                     const std::vector<const Graph::Causing*>& waiters, Findings& findings) {
  const Model& model = input.model;
  dsl::Diagnostic& finding =
      findings.add(promise.span, fmt::format("no task ever pushes for {}", name_of(model, promise.id)));
  std::set<dsl::Span> noted;
  std::string help; // for a task that waits for this promise
  Waiting waiting(model, input.facts);
  for (const Graph::Causing* arrow : waiters) {
    if (!noted.insert(arrow->condition.span).second) continue;
    if (const std::optional<StateId> state = find_exclusion(input, waiting, *arrow)) {
      finding.notes.push_back(
          {arrow->condition.span,
           fmt::format("{} waits for it here, but never pushes {}: the two run only with different values of {}",
                       name_of(model, arrow->waiter), name_of(model, causer), name_of(model, *state))});
      add_exclusion(model, input.shared.push_exclusion(), *state, arrow->waiter, causer, finding.notes);
      if (help.empty() && !has_another(input, *arrow))
        help = propose_causer(model, *state, input.shared.push_exclusion().values_of(*state, arrow->waiter),
                              arrow->condition.id);
      continue;
    }
    if (const auto rival = pushers.preferred(causer, arrow->condition.id);
        rival && pushers.may_push(*rival, arrow->condition.id)) {
      finding.notes.push_back(
          {arrow->condition.span, fmt::format("{} waits for it here", name_of(model, arrow->waiter))});
      if (noted.insert(model.providers[*rival].span).second)
        finding.notes.push_back(
            {model.providers[*rival].span,
             fmt::format("{} causes it too, and is always pushed instead", name_of(model, *rival))});
      continue;
    }
    finding.notes.push_back(
        {arrow->condition.span, fmt::format("{} looks at it here, and never waits for it where it could push",
                                            name_of(model, arrow->waiter))});
  }
  advise(input, causer, promise, finding);
  if (!help.empty()) finding.help = help;
}

} // namespace

void unused_causing(const Input& input, Findings& findings) {
  const Model& model = input.model;
  Pushers pushers(input);
  std::set<dsl::Span> reported; // awaited, and reported
  for (const Imprecise& fault : input.shared.imprecise()) reported.insert(fault.promise.span);
  std::set<dsl::Span> waited;
  for (const Graph::Causing& arrow : input.graph.causing) waited.insert(arrow.promise.span);
  for (const ProviderId id : model.providers.ids()) {
    for (const ConditionUse& use : model.providers[id].causing) {
      if (reported.count(use.span) != 0) continue;
      if (waited.count(use.span) == 0) {
        advise(input, id, use, findings.add(use.span, fmt::format("nothing waits for {}", name_of(model, use.id))));
        continue;
      }
      // The check that reports why it never runs, or why those that wait never do, explains this.
      const std::vector<const Graph::Causing*> waiters = find_waiters(input, id, use);
      const bool any_runs = std::any_of(waiters.begin(), waiters.end(), [&](const Graph::Causing* arrow) {
        return input.facts.active.contains(arrow->waiter) || input.facts.capable.contains(arrow->waiter);
      });
      const Decisions& decisions = input.shared.decisions();
      const bool any_pushes =
          std::any_of(input.graph.causing.begin(), input.graph.causing.end(), [&](const Graph::Causing& arrow) {
            if (arrow.causer != id || arrow.promise.span != use.span) return false;
            // A pushed provider of its own group may wait for it, or a task that can have the group only by that one.
            const GroupId own = model.providers[id].group;
            if (model.providers[arrow.waiter].group == own && !input.facts.pushed.contains(arrow.waiter))
              return is_no_choice_for_need(input, id) && !decisions.never_pushed(model, id, arrow.condition.id);
            // As declared it may push for ever; the decisions treat it as corrected.
            if (input.facts.is_impossible(arrow.waiter, model.conditions[arrow.condition.id].state)) return true;
            return !decisions.never_pushed(model, id, arrow.condition.id) && pushers.may_push(id, arrow.condition.id) &&
                   !pushers.preferred(id, arrow.condition.id);
          });
      if (input.facts.active.contains(id) && !decisions.never_runs(model, id) && any_runs && !any_pushes)
        report_unpushed(input, pushers, id, use, waiters, findings);
    }
  }
}

} // namespace director::checks
