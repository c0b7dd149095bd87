// Header: compiler/checks/check.hpp. Test: compiler/checks/possible_pack_conflict.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/exclusion.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/pairs/pair_help.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/reported_pairs.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"
#include "compiler/checks/report_pack_conflicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace director::checks {

namespace {

/// The chain of a way to a group: from the group back to the task.
void add_chain(const Model& model, const Way& way, GroupId group, dsl::Diagnostic& finding) {
  std::vector<dsl::Note> steps;
  const GroupId task = way.combination.picks.front().group;
  for (bool found = true; group != task && found;) {
    found = false;
    for (const Combination::Pick& pick : way.combination.picks) {
      for (const Use<GroupId>& need : model.providers[pick.provider].needs) {
        if (found || need.id != group) continue;
        steps.push_back({need.span, fmt::format("{} needs {}", name_of(model, pick.provider), name_of(model, group))});
        group = pick.group;
        found = true;
      }
      if (found) break;
    }
  }
  finding.notes.insert(finding.notes.end(), steps.rbegin(), steps.rend());
}

/// Where two ways can be used together: ", when `…`". If their `when` exclude each other, one of them has to run
/// already, or both.
std::string when_in_words(const Input& input, const Way& a, const Way& b) {
  const Model& model = input.model;
  const Region begins_a = beginning(input, a), begins_b = beginning(input, b);
  const bool at_once = compatible(begins_a, begins_b);
  const bool b_runs = !at_once && compatible(begins_a, b.combination.region);
  const bool a_runs = !at_once && !b_runs && compatible(begins_b, a.combination.region);
  const bool both_run = !at_once && !a_runs && !b_runs;
  std::vector<std::string> things;
  const auto add = [&](const Way& way, bool runs) {
    for (const Combination::Pick& pick : way.combination.picks) {
      const Provider& provider = model.providers[pick.provider];
      for (const ConditionUse& use : runs && !provider.stay.empty() ? provider.stay : provider.when) {
        std::string name = name_of(model, use.id);
        if (std::find(things.begin(), things.end(), name) == things.end()) things.push_back(std::move(name));
      }
    }
  };
  add(a, a_runs || both_run);
  add(b, b_runs || both_run);
  if (things.empty()) return {};
  const std::string out = ", when " + list_of(things);
  return at_once    ? out
         : both_run ? out + " while both run already"
                    : fmt::format("{} while {} runs already", out, name_of(model, (a_runs ? a : b).provider()));
}

void report(const Input& input, const Pack& pack, const Sides& sides, const ClashingWays& clash, Findings& findings) {
  const Task& first = sides.first.task;
  const Task& second = sides.second.task;
  const Model& model = input.model;
  const GroupId group = groups_in_common(*clash.first, *clash.second).front();
  const std::string a = name_of(model, first.target), b = name_of(model, second.target);
  const std::string one = name_of(model, clash.first->provider()), other = name_of(model, clash.second->provider());
  const std::string want = fmt::format("{} and {} both want {}", one, other, name_of(model, group));
  dsl::Diagnostic& finding = findings.add(
      second.span, clash.always
                       ? fmt::format("{} and {} can be granted together only by other providers than the preferred "
                                     "ones: {}",
                                     a, b, want)
                       : fmt::format("{} and {} cannot always be granted together: {}", a, b, want));
  // If they are requested nowhere else, these never run.
  for (const ProviderId id : clash.losers) finding.rules_out.push_back(model.providers[id].span);
  finding.notes.push_back({first.span, fmt::format("{} is requested in the same unit", a)});
  add_chain(model, *clash.first, group, finding);
  add_chain(model, *clash.second, group, finding);
  const ProviderId x = clash.first_instead->provider(), y = clash.second_instead->provider();
  const ProviderId place = clash.first->provider() != x ? x : y;
  finding.notes.push_back({model.providers[place].span,
                           fmt::format("{} and {} can be granted together{}", name_of(model, x), name_of(model, y),
                                       when_in_words(input, *clash.first_instead, *clash.second_instead))});
  finding.help = propose(input, pack, sides, clash);
}

/// Pairs of members, the later one first, that may lead to one group.
std::set<std::pair<std::size_t, std::size_t>> find_rivals(Units& units, const std::vector<const Task*>& members) {
  std::map<GroupId, std::vector<std::size_t>> needed_by;
  for (std::size_t i = 0; i < members.size(); ++i) {
    for (const GroupId group : units.needed(members[i]->target)) needed_by[group].push_back(i);
  }
  std::set<std::pair<std::size_t, std::size_t>> out;
  for (const auto& [group, needing] : needed_by) {
    for (std::size_t b = 1; b < needing.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) out.emplace(needing[b], needing[a]);
    }
  }
  return out;
}

/// What the requester keeps from its tasks, whichever of its providers runs: one may keep what another one requested.
class KeptByRequester {
public:
  KeptByRequester(const Input& input, GroupId requester)
      : input_(input),
        requester_(requester),
        groups_(input.conflicts.takers().held_by(requester)) {}

  /// A group of this way that it keeps. What it needs and requests is one claim.
  std::optional<GroupId> find(const Way& way) const {
    for (const ProviderId id : input_.model.groups[requester_].providers) {
      if (input_.model.providers[id].needs_group(way.combination.picks.front().group)) return std::nullopt;
    }
    const auto kept =
        std::find_if(way.groups.begin(), way.groups.end(), [&](GroupId group) { return has(groups_, group); });
    return kept == way.groups.end() ? std::nullopt : std::optional(*kept);
  }

  std::vector<Way> without_kept(std::vector<Way> ways) const {
    ways.erase(std::remove_if(ways.begin(), ways.end(), [&](const Way& way) { return find(way).has_value(); }),
               ways.end());
    return ways;
  }

  /// Adds a note for each provider that has no other way than one that it keeps.
  void add_notes(const std::vector<Way>& all, dsl::Diagnostic& finding) const {
    std::set<ProviderId> seen;
    for (const Way& way : without_kept(all)) seen.insert(way.provider());
    for (const Way& way : all) {
      if (!seen.insert(way.provider()).second) continue;
      finding.notes.push_back(
          {input_.model.providers[way.provider()].span,
           fmt::format("{} takes {}, which {} keeps for itself", name_of(input_.model, way.provider()),
                       name_of(input_.model, *find(way)), name_of(input_.model, requester_))});
    }
  }

private:
  const Input& input_;
  GroupId requester_;
  const Groups& groups_;
};

/// Notes the conditions of the providers that never run beside the other task, and of those that exclude them.
void note_excluded(const Input& input, const KeptByRequester& kept, const PairSearch& search, const Sides& sides,
                   dsl::Diagnostic& finding) {
  const auto add = [&](dsl::Note note) { add_once(std::move(note), finding.notes); };
  std::set<StateId> states;
  std::set<ProviderId> conditional;
  for (const auto& [side, other] : {std::pair(&sides.first, &sides.second), std::pair(&sides.second, &sides.first)}) {
    std::set<ProviderId> all;
    for (const Way& way : kept.without_kept(side->ways)) all.insert(way.provider());
    for (const ProviderId id : all) {
      if (search.has(id)) continue;
      for (dsl::Note& note : explain_exclusion(input.model, input.facts, id, &side->task)) add(std::move(note));
      if (input.facts.excluded.contains(id)) continue;
      conditional.insert(id);
      for (const Way& way : other->ways) {
        for (const Combination::Pick& pick : way.combination.picks) conditional.insert(pick.provider);
      }
      for (const ConditionUse& use : input.model.providers[id].when)
        states.insert(input.model.conditions[use.id].state);
    }
  }
  for (const ProviderId id : conditional) {
    for (const ConditionUse& use : input.model.providers[id].when) {
      if (states.count(input.model.conditions[use.id].state) == 0) continue;
      add(input.model.providers[id].stay.empty()
              ? runs_only_while(input.model, id, use)
              : dsl::Note{use.span, fmt::format("{} begins only while {}", name_of(input.model, id),
                                                name_of(input.model, use.id))});
    }
  }
  shorten_list(finding.notes);
}

/// Reports two that would work together, were it not for what their requester keeps or where it requests them.
void report_never(const Input& input, const KeptByRequester& kept, const PairSearch& search, const Sides& sides,
                  const Sides& before, const ClashingWays& clash, Findings& findings) {
  const Task &first = sides.first.task, &second = sides.second.task;
  const Model& model = input.model;
  const GroupId group = groups_in_common(*clash.first, *clash.second).front();
  dsl::Diagnostic& finding =
      findings.add(second.span, fmt::format("{} and {} can never be granted together: {} and {} both want {}",
                                            name_of(model, first.target), name_of(model, second.target),
                                            name_of(model, clash.first->provider()),
                                            name_of(model, clash.second->provider()), name_of(model, group)));
  finding.rules_out_together = {first.span, second.span};
  finding.notes.push_back({first.span, fmt::format("{} is requested in the same unit", name_of(model, first.target))});
  add_chain(model, *clash.first, group, finding);
  add_chain(model, *clash.second, group, finding);
  kept.add_notes(before.first.ways, finding);
  kept.add_notes(before.second.ways, finding);
  note_excluded(input, kept, search, before, finding);
  finding.help = "request them in two packs";
}

/// Those that can be used within the region, with what this leaves of theirs.
std::vector<Way> within(const Region& region, std::vector<Way> ways) {
  for (Way& way : ways) way.combination.region.meet(region);
  ways.erase(std::remove_if(ways.begin(), ways.end(), [](const Way& way) { return way.combination.region.empty(); }),
             ways.end());
  return ways;
}

void look_at(const Input& input, Units& units, GroupId requester, const Pack& pack, Findings& findings) {
  const std::vector<const Task*> members = unit_members(input.model, pack);
  if (members.size() < 2) return;
  const KeptByRequester kept(input, requester);
  std::set<std::size_t> reported; // of long packs: each member once
  for (const auto& [j, i] : find_rivals(units, members)) {
    if (reported.count(j) != 0) continue;
    const auto first = find_ways(units, members[i]->target), second = find_ways(units, members[j]->target);
    if (!first || !second) continue;
    Region requested = input.facts.contexts[members[i]->target];
    requested.meet(input.facts.contexts[members[j]->target]);
    const std::vector<Way> left_first = within(requested, kept.without_kept(*first));
    const std::vector<Way> left_second = within(requested, kept.without_kept(*second));
    const Sides sides{{*members[i], left_first}, {*members[j], left_second}};
    const PairSearch search(input, sides);
    if (const auto clash = search.run()) {
      report(input, pack, sides, *clash, findings);
    } else if (const auto never = search.all_clash();
               never && units.verdict({members[i]->target, members[j]->target}) == UnitVerdict::possible) {
      report_never(input, kept, search, sides, {{*members[i], *first}, {*members[j], *second}}, *never, findings);
    } else {
      continue;
    }
    if (members.size() > longest_with_all_pairs) reported.insert(j);
  }
}

} // namespace

void possible_pack_conflict(const Input& input, Findings& findings) {
  Units& units = input.shared.units();
  report_pack_conflicts(input, false, findings);
  for (const ProviderId id : input.model.providers.ids()) {
    const Provider& provider = input.model.providers[id];
    if (!provider.has_packs || !input.facts.active.contains(id)) continue;
    for (const Pack& pack : provider.packs) look_at(input, units, provider.group, pack, findings);
  }
}

} // namespace director::checks
