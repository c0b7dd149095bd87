// Header: compiler/checks/check.hpp. Test: compiler/checks/shadowed_provider.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/promises.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/facts/shadows.hpp"
#include "compiler/analysis/facts/waiting.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/choice.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/words/proposals.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"
#include "compiler/checks/report_never_running.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace director::checks {

namespace {

/// Limit for the rivals with a note.
constexpr std::size_t most_culprits = 8;

/// Whether a condition of it is reported as one that never holds: that is the reason, not the providers before it.
bool never_holds(const Facts& facts, ProviderId id) {
  const auto faults = facts.impossible_of(id);
  return std::any_of(faults.begin(), faults.end(), [](const Impossible& fault) { return !fault.stay; });
}

/// Notes the other members, if something is left where its group is requested, but not where it can be granted together
/// with them.
void note_members(const Input& input, ProviderId id, const std::vector<Rival>& rivals, dsl::Diagnostic& finding) {
  const GroupId group = input.model.providers[id].group;
  if (input.facts.grants[group].states == input.facts.contexts[group].states) return;
  Region own = region_of(input.model, input.model.providers[id].when);
  own.meet(input.facts.contexts[group]);
  if (find_choice(input.model, own, rivals, input.facts.values, input.shared.budget()) == Covering::covered) return;
  for (const Provider& requester : input.model.providers) {
    for (const Pack& pack : requester.packs) {
      const auto at =
          std::find_if(pack.tasks.begin(), pack.tasks.end(), [&](const Task& task) { return task.target == group; });
      if (pack.name.empty() || at == pack.tasks.end()) continue;
      for (const Task& other : pack.tasks) {
        if (other.target == group || !input.model.may_be_member(other) || !input.facts.may_wait.contains(other.target))
          continue;
        finding.notes.push_back(
            {other.span, fmt::format("{} is granted here only together with {}, which waits for conditions of its own",
                                     name_of(input.model, group), name_of(input.model, other.target))});
      }
    }
  }
}

/// Notes a condition of a preferred provider that always holds.
void note_always_true(const Input& input, ProviderId rival, dsl::Diagnostic& finding) {
  for (const ConditionUse& use : input.model.providers[rival].when) {
    const StateId state = input.model.conditions[use.id].state;
    const ValueSet& values = input.facts.values[state];
    if (input.model.states[state].may_be_unset() || values.empty()) continue;
    if (!values.subset_of(input.model.conditions[use.id].accepts)) continue;
    finding.notes.push_back(
        {use.span, fmt::format("{} always holds: {} is only ever {}", name_of(input.model, use.id),
                               name_of(input.model, state), values_in_words(input.model.states[state], values))});
  }
}

/// Notes why no group that waits for its promise pushes it: others of that group can run instead, so it never waits; or
/// it never goes first; or their conditions exclude that.
struct Unpushed {
  std::optional<GroupId> outranked; ///< the first that never goes first
  bool excluded = false;
};
Unpushed note_unpushed(const Input& input, ProviderId id, dsl::Diagnostic& finding) {
  const Model& model = input.model;
  const GroupId own = model.providers[id].group;
  Unpushed out;
  if (model.providers[id].causing.empty()) return out;
  Waiting waiting(model, input.facts);
  for (const ProviderId other : model.providers.ids()) {
    const GroupId group = model.providers[other].group;
    if (!input.facts.requested.contains(group) || group == own) continue;
    const bool waits = waiting.may_wait(group);
    const bool goes_before = waits && input.shared.chains().may_beat(group, own);
    const std::optional<StateId> state = input.shared.push_exclusion().find(other, id);
    if (goes_before && !state) continue;
    for (const ConditionUse& use : model.providers[other].when) {
      if (!model.causes(id, use.id)) continue;
      if (goes_before) {
        finding.notes.push_back(
            {use.span,
             fmt::format("{} waits for this, but never pushes {}: the two run only with different values of {}",
                         name_of(model, other), name_of(model, id), name_of(model, *state))});
        add_exclusion(model, input.shared.push_exclusion(), *state, other, id, finding.notes);
        out.excluded = true;
        continue;
      }
      const std::string name = name_of(model, group);
      finding.notes.push_back(
          {use.span,
           waits ? fmt::format(
                       "{} waits for this, but cannot push {}: that does not rank after it, or is granted with it",
                       name_of(model, other), name_of(model, own))
           : input.facts.holds_always(model, use.id, Region{})
               ? fmt::format("{} looks at this, but never waits for it: it always holds", name_of(model, other))
               : fmt::format("{} looks at this, but {} never waits for it: another provider of it can run",
                             name_of(model, other), name)});
      if (waits && !out.outranked) out.outranked = group;
    }
  }
  return out;
}

/// Another order helps if then no other provider never runs: neither one of these, nor one whose promise is never
/// pushed. `promises`: it is meant to be pushed, and would then run without that.
void propose(const Input& input, const Shadows& shadows, ProviderId id, const Culprits& culprits, bool promises,
             dsl::Diagnostic& finding) {
  const Model& model = input.model;
  const std::vector<ProviderId>& providers = model.group_of(id).providers;
  const bool helps = !promises && std::none_of(culprits.all.begin(), culprits.all.end(), [&](ProviderId each) {
    const bool is_promise = !model.providers[each].causing.empty() && !input.facts.pushed.contains(each);
    return is_promise || can_always_replace(model, id, each);
  }) && std::none_of(providers.begin(), std::find(providers.begin(), providers.end(), id), [&](ProviderId each) {
    return shadows.would_be_shadowed(each, id);
  });
  const bool is_one = culprits.all.size() == 1;
  const std::string help =
      fmt::format("give {} a `when` that leaves something", culprits.others_are_enough ? "those before it"
                                                            : is_one        ? name_of(model, culprits.all.front())
                                                            : culprits.each ? "each of them"
                                                                            : "one of them");
  if (helps)
    finding.help = fmt::format("{}, or put this one {}", help,
                               culprits.others_are_enough || !culprits.each ? "first"
                               : is_one                                     ? "before it"
                                                                            : "before them");
  else
    propose_or_leave_out(input.model, input.facts, id, help, finding);
}

} // namespace

void shadowed_provider(const Input& input, Findings& findings) {
  const Model& model = input.model;
  const Facts& facts = input.facts;
  const Rivals& rivals = input.shared.rivals();
  const Shadows shadows(model, facts, rivals, input.shared.budget());
  IdSet<ProviderId> explained = input.shared.promises().explained;
  for (const Imprecise& fault : input.shared.imprecise()) explained.add(fault.causer);
  // A condition that is reported as never holding may still be pushed for.
  for (const Impossible& fault : facts.impossible) {
    if (fault.stay) continue;
    for (const ConditionUse& use : fault.uses) {
      for (const ProviderId causer : input.shared.causers()[use.id]) explained.add(causer);
    }
  }
  for (const ProviderId id : input.shared.promises().never_run) report_never(input, id, findings);
  for (const auto& [id, refused] : input.conflicts.grants().idle()) report_idle(input, id, refused, findings);
  for (const ProviderId id : model.providers.ids()) {
    const Provider& provider = model.providers[id];
    if (!facts.requested.contains(provider.group) || !facts.capable.contains(id) || facts.active.contains(id)) continue;
    if (explained.contains(id) || never_holds(facts, id)) continue;
    if (facts.excluded.contains(id)) {
      if (input.model.has_any(provider.group, input.facts.active)) report_excluded(input, id, findings);
      continue;
    }
    if (!facts.impossible.empty() && !shadows.is_shadowed(id)) continue;
    std::vector<std::string> names;
    const Culprits culprits = shadows.find_culprits(id);
    for (const ProviderId rival : culprits.all) names.push_back(name_of(model, rival));
    const bool are_all = !culprits.each || names.size() < Shadows::most_left_out;
    dsl::Diagnostic& finding = findings.add(
        provider.span,
        names.size() == 1
            ? fmt::format("{} never runs: {} comes before it and can run whenever it can", name_of(model, id), names[0])
            : fmt::format("{} never runs: {} come before it, and {} of them can run whenever it can",
                          name_of(model, id), few_of(names, are_all ? "and" : "and at least"),
                          culprits.each ? "each" : "one"));
    finding.rules_out = {provider.span};
    for (std::size_t i = 0; i < std::min(culprits.all.size(), most_culprits); ++i) {
      finding.notes.push_back({model.providers[culprits.all[i]].span, fmt::format("{} is preferred", names[i])});
      note_always_true(input, culprits.all[i], finding);
    }
    const Unpushed unpushed = note_unpushed(input, id, finding);
    note_members(input, id, rivals.of(id), finding);
    if (unpushed.outranked)
      propose_or_leave_out(input.model, input.facts, id,
                           fmt::format("let {} go before {}, not in one unit with it",
                                       name_of(model, *unpushed.outranked), name_of(model, provider.group)),
                           finding);
    else
      propose(input, shadows, id, culprits, unpushed.excluded, finding);
  }
}

} // namespace director::checks
