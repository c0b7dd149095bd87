// Header: compiler/checks/report_pack_conflicts.hpp. Test: compiler/checks/pack_conflict.md.
// SPDX-License-Identifier: MIT
#include "compiler/checks/report_pack_conflicts.hpp"

#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/conflicts/pack_conflicts.hpp"
#include "compiler/analysis/pairs/pair_help.hpp"
#include "compiler/analysis/conflicts/starving.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/choice.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/reported_pairs.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/base/counted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

namespace director::checks {

namespace {

using dsl::Diagnostic;

/// A group that two tasks cannot run without, by the shortest chains.
struct SharedGroup {
  GroupId group{};
  std::vector<ChainStep> first, second;
};

std::optional<SharedGroup> find_shared_group(const Input& input, GroupId a, GroupId b) {
  std::optional<SharedGroup> best;
  for (const GroupId group : input.shared.indispensable().in_common(a, b)) {
    SharedGroup shared{group, need_path(input.model, a, group), need_path(input.model, b, group)};
    if (!best || shared.first.size() + shared.second.size() < best->first.size() + best->second.size())
      best = std::move(shared);
  }
  return best;
}

/// A state on which no choices of the two agree.
std::optional<StateId> find_split_state(Units& units, GroupId a, GroupId b) {
  const Region first = units.region_at_best(a), second = units.region_at_best(b);
  for (const auto& [state, values] : first.states) {
    const auto at = second.states.find(state);
    if (at != second.states.end() && !values.overlaps(at->second)) return state;
  }
  return std::nullopt;
}

void add_conditions(const Model& model, Units& units, GroupId member, StateId state, Diagnostic& finding) {
  const auto add = [&](ProviderId id, const std::vector<ConditionUse>& uses, std::string_view word) {
    for (const ConditionUse& use : uses) {
      if (model.conditions[use.id].state == state)
        finding.notes.push_back({use.span, fmt::format("{} {} {}", name_of(model, id), word, name_of(model, use.id))});
    }
  };
  for (const GroupId group : units.needed(member)) {
    for (const ProviderId id : model.groups[group].providers) {
      add(id, model.providers[id].when, "runs when");
      add(id, model.providers[id].stay, "stays while");
    }
  }
}

/// Adds what each choice takes and where it runs, for a conflict that no single group or state explains.
void add_choices(const Model& model, const std::vector<const Task*>& members, Diagnostic& finding) {
  for (const Task* member : members) {
    for (const ProviderId id : model.groups[member->target].providers) {
      const Provider& provider = model.providers[id];
      std::vector<std::string> needs, conditions;
      for (const Use<GroupId>& need : provider.needs) needs.push_back(name_of(model, need.id));
      for (const ConditionUse& use : provider.when) conditions.push_back(name_of(model, use.id));
      std::string text;
      if (!needs.empty()) text = fmt::format("takes {}", list_of(needs));
      if (!conditions.empty()) text += fmt::format("{}runs when {}", text.empty() ? "" : " and ", list_of(conditions));
      if (!text.empty()) finding.notes.push_back({provider.span, fmt::format("{} {}", name_of(model, id), text)});
    }
  }
}

/// Of two tasks that take the same group the one that is granted, if the second one were not in the unit.
const Task& winner_of(const Model& model, const Task& first, const Task& second) {
  const auto rank = [&](const Task& task) {
    const auto& levels = model.edges[task.edge].levels;
    return std::pair(levels[task.levels.front().level].priority, task.edge == std::min(first.edge, second.edge));
  };
  return rank(first) < rank(second) ? second : first;
}

/// Whether the one of two members that goes first can run wherever the other one can: `apart`, that one never would.
bool first_takes_always(const Input& input, const Task& first, const Task& second) {
  const Task& winner = winner_of(input.model, first, second);
  const Task& loser = &winner == &first ? second : first;
  Units& units = input.shared.units();
  return never_waits(input, winner.target) ||
         find_covering(input.model, units.region_at_best(loser.target), {units.region_at_best(winner.target)},
                       input.facts.values, input.shared.budget()) == Covering::covered;
}

/// `by_groups`: they exclude each other with all values of states.
std::string propose(const Input& input, const PackConflict& conflict, bool by_groups) {
  const Model& model = input.model;
  if (!model.providers[conflict.provider].has_packs)
    return "give the provider `packs`, one for each course of action: a flat list says that all may be requested at "
           "once";
  // A task that never has to wait would always take what an `apart` one wants.
  const auto always_takes = [&](const Task* task) { return never_waits(input, task->target); };
  if (!conflict.others.empty())
    return std::any_of(conflict.members.begin(), conflict.members.end(), always_takes) ||
                   std::any_of(conflict.others.begin(), conflict.others.end(), always_takes)
               ? "request them in packs of their own"
               : "request them in packs of their own, or make all but one of them `apart`, so that each waits for "
                 "itself alone";
  if (conflict.members.size() == 2) {
    std::string help = apart_to_be_pushed(model, *conflict.members[0], *conflict.members[1]);
    if (!help.empty()) return help;
  }
  if (conflict.members.size() == 2 && by_groups &&
      first_takes_always(input, *conflict.members[0], *conflict.members[1]))
    return "request them in two packs";
  // Alone, one that never has to wait would need none but the first of its providers.
  if (conflict.members.size() > 2 && std::any_of(conflict.members.begin(), conflict.members.end(), always_takes))
    return "request one of them in another pack, together with one of the others";
  return conflict.members.size() == 2
             ? fmt::format("request them in two packs, or make {} `apart`, so that it waits for itself alone",
                           name_of(model, conflict.members[1]->target))
             : "request them in two packs, or make one of them `apart`, so that it waits for itself alone";
}

/// "`A` and `B`".
std::string members_in_words(const Model& model, const std::vector<const Task*>& members) {
  std::vector<std::string> names;
  for (const Task* member : members) names.push_back(name_of(model, member->target));
  return list_of(names);
}

/// Why the members exclude each other, if one group or one state explains it.
struct Reason {
  std::optional<SharedGroup> shared;
  std::optional<StateId> state;
};

Reason reason_for(const Input& input, const PackConflict& conflict) {
  if (conflict.members.size() != 2) return {};
  const GroupId a = conflict.members[0]->target, b = conflict.members[1]->target;
  if (auto shared = find_shared_group(input, a, b)) return {std::move(shared), std::nullopt};
  return {std::nullopt, find_split_state(input.shared.units(), a, b)};
}

std::string headline(const Model& model, const PackConflict& conflict, const Reason& reason) {
  const std::vector<const Task*>& members = conflict.members;
  const std::size_t more = conflict.others.size();
  const std::string begin =
      more == 0 ? fmt::format("{} can never be granted together", members_in_words(model, members))
                : fmt::format("{} can never be granted together with {} and {}", name_of(model, members[0]->target),
                              name_of(model, members[1]->target), counted(more, "other"));
  const GroupId a = members[0]->target, b = members[1]->target;
  if (reason.shared && (reason.shared->group == a || reason.shared->group == b)) {
    const bool of_first = reason.shared->group == b;
    return fmt::format("{}: {} holds {} for itself", begin, name_of(model, of_first ? a : b),
                       name_of(model, of_first ? b : a));
  }
  if (reason.shared)
    return fmt::format("{}: {} come down to {}", begin, more == 0 ? "both" : "all",
                       name_of(model, reason.shared->group));
  if (reason.state)
    return fmt::format("{}: what they accept of {} excludes each other", begin, name_of(model, *reason.state));
  return fmt::format("{}: no choice of providers serves all of them at once", begin);
}

void add_reasons(const Input& input, const PackConflict& conflict, const Reason& reason, Diagnostic& finding) {
  const Model& model = input.model;
  const std::vector<const Task*>& members = conflict.members;
  for (std::size_t i = 0; i + 1 < members.size(); ++i)
    finding.notes.push_back(
        {members[i]->span, fmt::format("{} is requested in the same unit", name_of(model, members[i]->target))});
  if (reason.shared) {
    add_chain(model, reason.shared->first, finding.notes);
    add_chain(model, reason.shared->second, finding.notes);
  } else if (reason.state) {
    add_conditions(model, input.shared.units(), members[0]->target, *reason.state, finding);
    add_conditions(model, input.shared.units(), members[1]->target, *reason.state, finding);
  } else {
    add_choices(model, members, finding);
  }
  for (const Task* other : conflict.others)
    finding.notes.push_back({other->span, fmt::format("nor with {}", name_of(model, other->target))});
}

void report(const Input& input, const PackConflict& conflict, Findings& findings) {
  const Model& model = input.model;
  const Span place = conflict.members.back()->span;
  if (conflict.verdict == UnitVerdict::undecided) {
    findings
        .add(place, fmt::format("whether {} can ever be granted together was not decided within {} steps",
                                members_in_words(model, conflict.members), Units::most_steps))
        .help = "with fewer alternatives it would be: give the groups below fewer providers, or fewer needs";
    return;
  }
  const Reason reason = reason_for(input, conflict);
  Diagnostic& finding = findings.add(place, headline(model, conflict, reason));
  for (const Task* member : conflict.members) finding.rules_out_together.push_back(member->span);
  for (const Task* other : conflict.others) finding.rules_out_together.push_back(other->span);
  add_reasons(input, conflict, reason, finding);
  finding.help = propose(input, conflict, !reason.state);
  if (const auto kept_off = find_kept_off(input, conflict)) {
    const std::string need = name_of(model, kept_off->need->id);
    finding.notes.push_back(
        {kept_off->need->span, fmt::format("{} needs {}", name_of(model, conflict.provider), need)});
    finding.help = fmt::format("let {} do without {}, or do not need {} and request the two in two packs",
                               name_of(model, kept_off->member->target), name_of(model, kept_off->group), need);
  }
}

/// Why two members exclude each other, if a third one may do so for the same reason; else empty.
std::string reason_of(const Input& input, const PackConflict& conflict) {
  const GroupId a = conflict.members[0]->target, b = conflict.members[1]->target;
  const auto [shared, state] = reason_for(input, conflict);
  if (shared) return shared->group == a || shared->group == b ? "" : "group " + name_of(input.model, shared->group);
  return state ? "state " + name_of(input.model, *state) : "";
}

/// In a long unit, everything that one member excludes for one reason is one conflict.
std::vector<PackConflict> gathered(const Input& input, const std::vector<PackConflict>& all) {
  std::vector<PackConflict> out;
  std::map<std::tuple<const Pack*, const Task*, std::string>, std::size_t> known;
  for (const PackConflict& each : all) {
    const bool is_long = unit_members(input.model, *each.pack).size() > longest_with_all_pairs;
    const std::string reason = is_long && each.members.size() == 2 ? reason_of(input, each) : "";
    if (!reason.empty()) {
      const auto [at, is_new] = known.try_emplace({each.pack, each.members[0], reason}, out.size());
      if (!is_new) {
        out[at->second].others.push_back(each.members[1]);
        continue;
      }
    }
    out.push_back(each);
  }
  return out;
}

/// The provider needs all of them too, so that it never runs: needs_conflict says why.
bool is_needs_conflict(const Input& input, const PackConflict& conflict) {
  if (input.facts.plans[conflict.provider] != PlanVerdict::none) return false;
  const auto is_needed = [&](const Task* member) {
    return input.model.providers[conflict.provider].needs_group(member->target);
  };
  return conflict.others.empty() && std::all_of(conflict.members.begin(), conflict.members.end(), is_needed) &&
         input.shared.units().verdict(conflict.targets(), true) == UnitVerdict::impossible;
}

} // namespace

void report_pack_conflicts(const Input& input, bool of_packs, Findings& findings) {
  for (const PackConflict& conflict : gathered(input, input.conflicts.pack_conflicts())) {
    if (input.model.providers[conflict.provider].has_packs != of_packs || is_needs_conflict(input, conflict)) continue;
    // Of a list, self_conflict says what is certain.
    if (of_packs || !find_kept_off(input, conflict)) report(input, conflict, findings);
  }
}

} // namespace director::checks
