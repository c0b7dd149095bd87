// Header: compiler/analysis/words/proposals.hpp. Test: tests/compiler/checks/helps_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/proposals.hpp"

#include "compiler/analysis/facts/waiting.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "dsl/source/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace director::analysis {

using namespace director::compiler;

std::string put_last(const Model& model, ProviderId id, const std::function<bool(const ConditionUse&)>& removed) {
  const Provider& provider = model.providers[id];
  const bool is_last = model.groups[provider.group].providers.back() == id;
  if (is_last || !provider.needs.empty() || !std::all_of(provider.when.begin(), provider.when.end(), removed))
    return {};
  return ", and put it last";
}

void add_exclusion(const Model& model, const PushExclusion& exclusion, StateId state, ProviderId waiter,
                   ProviderId causer, std::vector<dsl::Note>& notes) {
  for (const ProviderId id : {waiter, causer}) {
    for (const auto& [at, use] : exclusion.conditions_on(state, id)) {
      const GroupId group = model.providers[at].group;
      for (const Use<GroupId>& need : model.providers[id].needs) {
        if (at != id && need.id == group)
          add_once({need.span, fmt::format("{} needs {}", name_of(model, id), name_of(model, group))}, notes);
      }
      add_once(runs_only_while(model, at, use), notes);
    }
  }
}

std::string propose_causer(const Model& model, StateId state, const ValueSet& values, ConditionId wanted) {
  return fmt::format("let a provider cause {} that can run while {} is {}", name_of(model, wanted),
                     name_of(model, state), values_in_words(model.states[state], values));
}

namespace {

/// Whether it may be chosen for a need of its group.
bool may_serve_need(const Model& model, const Facts& facts, ProviderId id) {
  if (!facts.capable.contains(id)) return false;
  const std::vector<ProviderId>& all = model.group_of(id).providers;
  const auto end = std::find(all.begin(), all.end(), id);
  return std::none_of(all.begin(), end, [&](ProviderId earlier) { return can_always_replace(model, earlier, id); });
}

/// Whether a condition of another group would never hold without what this provider sets, or not again once others have
/// set the state.
bool is_only_source(const Model& model, ProviderId id) {
  const Provider& provider = model.providers[id];
  if (provider.sets.empty() && provider.causing.empty()) return false;
  std::set<ConditionId> awaited;
  for (const Provider& waiter : model.providers) {
    if (waiter.group == provider.group) continue;
    for (const auto* uses : {&waiter.when, &waiter.stay}) {
      for (const ConditionUse& use : *uses) awaited.insert(use.id);
    }
  }
  const auto sources = find_sources(model);
  return std::any_of(awaited.begin(), awaited.end(), [&](ConditionId each) {
    const ValueSet& accepts = model.conditions[each].accepts;
    bool is_given = false, is_given_by_others = false, is_initial = false, is_lost = false;
    for (const Source& source : sources[model.conditions[each].state]) {
      is_lost = is_lost || !source.values.subset_of(accepts);
      if (!source.values.overlaps(accepts)) continue;
      const bool initial = source.kind == Source::Kind::initial;
      is_initial = is_initial || initial;
      is_given = is_given || source.provider == id;
      is_given_by_others = is_given_by_others || (!initial && source.provider != id);
    }
    return is_given && !is_given_by_others && (is_lost || !is_initial);
  });
}

} // namespace

void propose_or_leave_out(const Model& model, const Facts& facts, ProviderId provider, const std::string& help,
                          dsl::Diagnostic& finding) {
  const GroupId group = model.providers[provider].group;
  const bool may_serve = may_serve_need(model, facts, provider);
  for (const Provider& needer : model.providers) {
    if (!may_serve || needer.group == group) continue;
    for (const Use<GroupId>& need : needer.needs) {
      if (need.id != group) continue;
      finding.notes.push_back(
          {need.span, fmt::format("{} may hold {} by it here", name_of(model, needer.group), name_of(model, group))});
      finding.help = help;
      return;
    }
  }
  finding.help =
      is_only_source(model, provider) ? help : fmt::format("{}, or leave {} out", help, name_of(model, provider));
}

} // namespace director::analysis
