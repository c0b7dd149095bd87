// Door: compiler/checks/check.hpp. Test: compiler/checks/unused_causing.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace director::checks {

namespace {

/// Providers with the conditions for which some task may push them.
std::set<std::pair<ProviderId, ConditionId>> find_pushes(const Input& input) {
  std::set<std::pair<ProviderId, ConditionId>> out;
  for (const Wanting& wanting : input.shared.wants()) {
    for (const Want& want : wanting.wants) {
      for (const ProviderId causer : want.causers) out.insert({causer, want.condition.id});
    }
  }
  return out;
}

/// Those with a condition that it satisfies, of other groups.
std::vector<const Graph::Causing*> find_waiters(const Input& input, ProviderId id, const ConditionUse& promise) {
  std::vector<const Graph::Causing*> out;
  for (const Graph::Causing& arrow : input.graph.causing) {
    if (arrow.causer == id && arrow.promise.span == promise.span &&
        input.model.providers[arrow.waiter].group != input.model.providers[id].group)
      out.push_back(&arrow);
  }
  return out;
}

/// A task that looks at the promise by way of its needs never runs for another reason, which is told; it may push all
/// the same.
bool has_idle_task(const Input& input, const std::vector<const Graph::Causing*>& waiters) {
  for (const ProviderId id : input.model.providers.ids()) {
    const GroupId group = input.model.providers[id].group;
    if (!input.facts.requested.contains(group) || input.facts.capable.contains(id)) continue;
    const std::vector<GroupId>& needed = input.shared.units().needed(group);
    for (const Graph::Causing* arrow : waiters) {
      if (std::binary_search(needed.begin(), needed.end(), input.model.providers[arrow->waiter].group)) return true;
    }
  }
  return false;
}

/// Members of one unit push each other, although that seldom comes to anything: none is granted without the others but
/// below a requester with new orders.
bool is_beside(const Input& input, ProviderId id, const std::vector<const Graph::Causing*>& waiters) {
  const GroupId group = input.model.providers[id].group;
  bool out = false;
  for (const GroupId task : input.model.groups.ids()) {
    if (out || !input.facts.requested.contains(task)) continue;
    const std::vector<GroupId>& needed = input.shared.units().needed(task);
    const bool waits = std::any_of(waiters.begin(), waiters.end(), [&](const Graph::Causing* arrow) {
      return std::binary_search(needed.begin(), needed.end(), input.model.providers[arrow->waiter].group);
    });
    if (!waits) continue;
    input.shared.chains().visit(task, {group}, [&](const Meeting& meeting, GroupId) {
      out = out || (meeting.one_unit() && meeting.second->target == group && meeting.first_goes_before());
    });
  }
  return out;
}

/// Nobody who looks at it ever pushes for it: it holds, or they can do without, or they go after this group.
void report_unpushed(const Input& input, const ConditionUse& promise, const std::vector<const Graph::Causing*>& waiters,
                     Findings& findings) {
  const Model& model = input.model;
  dsl::Diagnostic& finding =
      findings.add(promise.span, fmt::format("no task ever pushes for {}", name_of(model, promise.id)));
  std::set<dsl::Span> noted;
  for (const Graph::Causing* arrow : waiters) {
    if (!noted.insert(arrow->condition.span).second) continue;
    finding.notes.push_back(
        {arrow->condition.span, fmt::format("{} looks at it here, and never waits for it where it could push",
                                            name_of(model, arrow->waiter))});
  }
  finding.help = "what a provider sets without a promise to anybody stands in `sets`";
}

} // namespace

void unused_causing(const Input& input, Findings& findings) {
  const Model& model = input.model;
  const auto pushes = find_pushes(input);
  std::set<dsl::Span> told; // waited for, and told of
  for (const Imprecise& fault : input.shared.imprecise()) told.insert(fault.promise.span);
  std::set<dsl::Span> waited;
  for (const Graph::Causing& arrow : input.graph.causing) waited.insert(arrow.promise.span);
  for (const ProviderId id : model.providers.ids()) {
    for (const ConditionUse& use : model.providers[id].causing) {
      if (told.count(use.span) != 0) continue;
      if (waited.count(use.span) == 0) {
        findings.add(use.span, fmt::format("nothing waits for {}", name_of(model, use.id))).help =
            "what a provider sets without a promise to anybody stands in `sets`";
        continue;
      }
      // Why it never runs, or why those that wait never do, is told as that.
      const std::vector<const Graph::Causing*> waiters = find_waiters(input, id, use);
      const bool any_runs = std::any_of(waiters.begin(), waiters.end(), [&](const Graph::Causing* arrow) {
        return input.facts.active.contains(arrow->waiter) || input.facts.capable.contains(arrow->waiter);
      });
      const bool any_pushes = std::any_of(waiters.begin(), waiters.end(), [&](const Graph::Causing* arrow) {
        return pushes.count({id, arrow->condition.id}) != 0 ||
               input.facts.is_impossible(arrow->waiter, model.conditions[arrow->condition.id].state);
      });
      if (input.facts.active.contains(id) && any_runs && !any_pushes && !has_idle_task(input, waiters) &&
          !is_beside(input, id, waiters))
        report_unpushed(input, use, waiters, findings);
    }
  }
}

} // namespace director::checks
