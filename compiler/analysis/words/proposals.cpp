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
  const auto sources = find_sources(model);
  const auto is_own = [&](const Source& source) { return source.provider == id; };
  const auto waits_for_it = [&](const ConditionUse& use) {
    const Condition& condition = model.conditions[use.id];
    std::vector<Source> giving;
    bool is_lost = false;
    for (const Source& each : sources[condition.state]) {
      if (!each.values.intersected(condition.accepts).empty()) giving.push_back(each);
      is_lost = is_lost || !each.values.without(condition.accepts).empty();
    }
    if (is_lost) std::erase_if(giving, [](const Source& each) { return each.kind == Source::Kind::initial; });
    return !giving.empty() && std::all_of(giving.begin(), giving.end(), is_own);
  };
  return std::any_of(model.providers.begin(), model.providers.end(), [&](const Provider& waiter) {
    return waiter.group != provider.group && (std::any_of(waiter.when.begin(), waiter.when.end(), waits_for_it) ||
                                              std::any_of(waiter.stay.begin(), waiter.stay.end(), waits_for_it));
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
