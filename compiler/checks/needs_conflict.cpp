// Header: compiler/checks/check.hpp. Test: compiler/checks/needs_conflict.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

namespace {

using dsl::Diagnostic;

/// Two needs of a provider, and a group that is indispensable for both.
struct CommonGroup {
  const Use<GroupId>* first = nullptr;
  const Use<GroupId>* second = nullptr;
  GroupId group{};
  std::vector<ChainStep> from_first, from_second;
};

/// Limit for the groups whose chains are compared to find the shortest.
constexpr int most_compared = 200;

/// The one with the shortest chains; the first of several.
std::optional<CommonGroup> find_common_group(const Model& model, const Provider& provider,
                                             const Indispensable& indispensable) {
  std::optional<CommonGroup> best;
  std::size_t length = 0;
  int compared = 0;
  for (std::size_t j = 1; j < provider.needs.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      const Use<GroupId>& a = provider.needs[i];
      const Use<GroupId>& b = provider.needs[j];
      for (const GroupId group : indispensable.in_common(a.id, b.id)) { // none in a cycle, which another check reports
        if (compared++ == most_compared) return best;
        CommonGroup clash{&a, &b, group, need_path(model, a.id, group), need_path(model, b.id, group)};
        const std::size_t steps = clash.from_first.size() + clash.from_second.size();
        if (best && steps >= length) continue;
        length = steps;
        best = std::move(clash);
      }
    }
  }
  return best;
}

Diagnostic& report_common_group(const Model& model, ProviderId id, const CommonGroup& clash, Findings& findings) {
  const std::string provider = name_of(model, id);
  if (clash.first->id == clash.second->id) {
    Diagnostic& twice =
        findings.add(clash.second->span, fmt::format("{} needs {} twice", provider, name_of(model, clash.group)));
    twice.rules_out = {clash.second->span};
    twice.notes.push_back({clash.first->span, "needed first here"});
    twice.help = "a group is held once: leave one of them out";
    return twice;
  }
  Diagnostic& finding =
      findings.add(clash.second->span, fmt::format("{} can never run: its needs {} and {} both come down to {}",
                                                   provider, name_of(model, clash.first->id),
                                                   name_of(model, clash.second->id), name_of(model, clash.group)));
  finding.rules_out = {clash.second->span};
  finding.notes.push_back({clash.first->span, fmt::format("the other need is {}", name_of(model, clash.first->id)),
                           dsl::Note::Link::first});
  add_chain(model, clash.from_first, finding.notes, dsl::Note::Link::next);
  add_chain(model, clash.from_second, finding.notes);
  finding.help =
      fmt::format("need only one of them, or give one a provider that does without {}", name_of(model, clash.group));
  return finding;
}

/// The groups that a way to meet a need takes: its own needs, and what these lead to with any provider.
std::string taken_by(const Model& model, const Provider& way, const Indispensable& indispensable) {
  std::vector<GroupId> own, below;
  const auto has = [](const std::vector<GroupId>& list, GroupId id) {
    return std::find(list.begin(), list.end(), id) != list.end();
  };
  for (const Use<GroupId>& need : way.needs) own.push_back(need.id);
  for (const GroupId id : own) {
    if (!indispensable.of(id)) continue;
    for (const GroupId deep : *indispensable.of(id)) {
      if (!has(own, deep) && !has(below, deep)) below.push_back(deep);
    }
  }
  const auto named = [&](const std::vector<GroupId>& list) {
    std::vector<std::string> out;
    for (const GroupId id : list) out.push_back(name_of(model, id));
    return list_of(out);
  };
  return below.empty() ? named(own) : fmt::format("{}, and with it {}", named(own), named(below));
}

/// Lists the groups that each way to meet a need takes, for a conflict of more than two needs.
Diagnostic& report_crowd(const Model& model, ProviderId id, const Indispensable& indispensable, Findings& findings) {
  const Provider& provider = model.providers[id];
  std::vector<std::string> names;
  for (const Use<GroupId>& need : provider.needs) names.push_back(name_of(model, need.id));
  Diagnostic& finding =
      findings.add(provider.needs[0].span, fmt::format("{} can never run: no choice of providers gives it {} at once",
                                                       name_of(model, id), list_of(names)));
  finding.rules_out = {provider.needs[0].span};
  for (const Use<GroupId>& need : provider.needs) {
    for (const ProviderId way : model.groups[need.id].providers) {
      if (model.providers[way].needs.empty()) continue;
      finding.notes.push_back(
          {model.providers[way].span,
           fmt::format("{} would take {}", name_of(model, way), taken_by(model, model.providers[way], indispensable))});
    }
  }
  finding.help = fmt::format("need less, or give one of {} a provider that needs less", list_of(names));
  return finding;
}

void report_undecided(const Input& input, const std::vector<ProviderId>& undecided, Findings& findings) {
  const Model& model = input.model;
  std::vector<std::string> names;
  for (const ProviderId id : undecided) names.push_back(name_of(model, id));
  Diagnostic& finding = findings.add(model.providers[undecided.front()].needs[0].span,
                                     fmt::format("whether {} can ever have all that {} was not decided within {} steps",
                                                 few_of(names, "or"), names.size() == 1 ? "it needs" : "they need",
                                                 input.shared.budget().exhausted() ? Budget::of_a_run : plan_steps));
  finding.help = "with fewer alternatives it would be: give the groups below fewer providers, or fewer needs";
}

/// Nor are they ever granted together where the provider requests what it needs.
void rule_out_packs(const Provider& provider, Diagnostic& finding) {
  for (const Pack& pack : provider.packs) {
    for (const Task& task : pack.tasks) {
      if (provider.needs_group(task.target)) finding.rules_out_together.push_back(task.span);
    }
  }
}

} // namespace

void needs_conflict(const Input& input, Findings& findings) {
  const Model& model = input.model;
  const std::vector<ProviderId> conflicts = find_need_conflicts(model, input.facts, input.shared.budget());
  std::vector<ProviderId> undecided; // one finding for all of them
  for (const ProviderId id : conflicts) {
    if (const auto clash = find_common_group(model, model.providers[id], input.shared.indispensable())) {
      rule_out_packs(model.providers[id], report_common_group(model, id, *clash, findings));
    } else if (input.facts.plans[id] == PlanVerdict::none) {
      rule_out_packs(model.providers[id], report_crowd(model, id, input.shared.indispensable(), findings));
    } else {
      undecided.push_back(id);
    }
  }
  if (!undecided.empty()) report_undecided(input, undecided, findings);
}

} // namespace director::checks
