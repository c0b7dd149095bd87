// Header: compiler/checks/check.hpp. Test: compiler/checks/possible_pack_conflict.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/exclusion.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/conflicts/pair_help.hpp"
#include "compiler/analysis/conflicts/ways.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/choice.hpp"
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

/// A member of the pack, and the ways to run it.
struct Side {
  const Task& task;
  const std::vector<Way>& ways;
};
using Sides = std::pair<Side, Side>;

/// Where it can begin: there each `when` holds, and not only a `stay`.
Region beginning(const Input& input, const Way& way) {
  Region out = way.combination.region;
  for (const Combination::Pick& pick : way.combination.picks) {
    const Provider& provider = input.model.providers[pick.provider];
    Region own = input.facts.region_to_begin(input.model, pick.provider);
    for (const ConditionUse& promise : provider.causing) own.states.erase(input.model.conditions[promise.id].state);
    out.meet(own);
  }
  return out;
}

/// Whether the tasks and all that they may need are requested and needed by nothing else: then both begin at once.
bool begin_together(const Input& input, const Task& first, const Task& second) {
  Units& units = input.shared.units();
  std::set<GroupId> all;
  for (const Task* task : {&first, &second}) {
    const std::vector<GroupId>& needed = units.needed(task->target);
    all.insert(needed.begin(), needed.end());
  }
  return std::all_of(all.begin(), all.end(), [&](GroupId group) {
    std::size_t entries = 0;
    for (const Request& request : input.shared.requests().of(group)) {
      if (!request.requester || all.count(input.model.providers[*request.requester].group) == 0) ++entries;
    }
    const std::vector<EdgeId>& edges = input.model.groups[group].requesters;
    return entries <= 1 && std::all_of(edges.begin(), edges.end(), [&](EdgeId id) {
             const Edge& edge = input.model.edges[id];
             const bool is_its = (id == first.edge || id == second.edge) && !edge.needed;
             return is_its || (edge.requester && all.count(*edge.requester) != 0);
           });
  });
}

/// Two ways that want one group, one for each of two members.
struct ClashingWays {
  const Way* first = nullptr;
  const Way* second = nullptr;
  const Way* first_instead = nullptr; ///< two ways that do not
  const Way* second_instead = nullptr;
  std::vector<ProviderId> losers; ///< of the two, those that never run here
  bool always = false;            ///< the preferred provider of one of them never runs here, with all values of states
};

class PairSearch {
public:
  PairSearch(const Input& input, const Sides& sides) : input_(input) {
    for (const Way& a : sides.first.ways) {
      for (const Way& b : sides.second.ways) {
        Region region = a.combination.region;
        region.meet(b.combination.region);
        if (region.empty()) continue;
        (groups_in_common(a, b).empty() ? working_ : clashing_).push_back({&a, &b, std::move(region)});
      }
    }
    const auto can_begin = [&](const Pair& pair) {
      return compatible(beginning(input, *pair.first), beginning(input, *pair.second));
    };
    const auto others = std::stable_partition(working_.begin(), working_.end(), can_begin);
    if (others == working_.begin() && !working_.empty() && begin_together(input, sides.first.task, sides.second.task))
      working_.clear();
  }

  /// Whether some two ways of theirs want one group or can be used together.
  bool has(ProviderId id) const {
    const auto is_its = [&](const Pair& pair) { return pair.first->provider() == id || pair.second->provider() == id; };
    return std::any_of(working_.begin(), working_.end(), is_its) ||
           std::any_of(clashing_.begin(), clashing_.end(), is_its);
  }

  /// Two ways that want one group, if no two ways can be used together.
  std::optional<ClashingWays> all_clash() const {
    if (clashing_.empty() || !working_.empty()) return std::nullopt;
    return ClashingWays{clashing_.front().first, clashing_.front().second, nullptr, nullptr, {}, true};
  }

  std::optional<ClashingWays> run() const {
    if (clashing_.empty() || working_.empty()) return std::nullopt;
    if (const Pair* useless = find_useless()) return make(*useless, true);
    std::vector<Region> regions;
    for (const Pair& pair : working_) regions.push_back(pair.region);
    for (const Pair& pair : clashing_) {
      if (find_covering(input_.model, pair.region, regions, input_.facts.values, input_.shared.budget()) ==
          Covering::open)
        return make(pair, false);
    }
    return std::nullopt;
  }

private:
  struct Pair {
    const Way* first;
    const Way* second;
    Region region;
  };

  ClashingWays make(const Pair& pair, bool always) const {
    ClashingWays out{pair.first, pair.second, working_.front().first, working_.front().second, {}, always};
    for (const auto side : {&Pair::first, &Pair::second}) {
      const ProviderId id = (pair.*side)->provider();
      if (std::none_of(working_.begin(), working_.end(),
                       [&](const Pair& works) { return (works.*side)->provider() == id; }))
        out.losers.push_back(id);
    }
    return out;
  }

  /// A conflict of a provider that is preferred to all that ever run here.
  const Pair* find_useless() const {
    const auto before_all = [&](const Way* way, const Way* Pair::*side) {
      return std::all_of(working_.begin(), working_.end(),
                         [&](const Pair& pair) { return way->provider() < (pair.*side)->provider(); });
    };
    for (const Pair& pair : clashing_) {
      if (before_all(pair.first, &Pair::first) || before_all(pair.second, &Pair::second)) return &pair;
    }
    return nullptr;
  }

  const Input& input_;
  std::vector<Pair> working_, clashing_;
};

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

bool is_requested_elsewhere(const Input& input, const Task& task) {
  return input.shared.requests().of(task.target).size() > 1;
}

/// It goes first then, and a unit goes as early as its first member.
std::string set_apart(const Model& model, const Pack& pack, const Task& task, const Task& other) {
  const auto priority = [&](const Task& one) {
    return model.edges[one.edge].levels[one.levels.front().level].priority;
  };
  const std::vector<const Task*> members = unit_members(model, pack);
  const std::string apart = fmt::format("make {} `apart`", name_of(model, task.target));
  if (std::all_of(members.begin(), members.end(),
                  [&](const Task* one) { return one == &task || priority(*one) < priority(task); }))
    return apart;
  return members.size() == 2 ? fmt::format("{}, with a higher priority than {}", apart, name_of(model, other.target))
                             : apart + ", with the highest priority here";
}

/// The providers that never run even alone, since others of their group come first.
std::vector<std::string> find_superfluous(const Input& input, const Side& side) {
  std::vector<std::string> out;
  std::set<ProviderId> useful;
  for (std::size_t i = 0; i < side.ways.size(); ++i) {
    if (comes_first(input, side.ways, i)) useful.insert(side.ways[i].provider());
  }
  for (const ProviderId id : input.model.groups[side.task.target].providers) {
    const bool is_tried =
        std::any_of(side.ways.begin(), side.ways.end(), [&](const Way& way) { return way.provider() == id; });
    if (!is_tried && is_requested_elsewhere(input, side.task)) continue;
    if (input.facts.active.contains(id) && useful.count(id) == 0) out.push_back(name_of(input.model, id));
  }
  return out;
}

/// The providers without which the two do not clash, if there are such, and neither task is requested elsewhere.
std::vector<std::string> find_left_out(const Input& input, const Sides& sides, const ClashingWays& clash) {
  std::vector<std::string> out;
  if (is_requested_elsewhere(input, sides.first.task) || is_requested_elsewhere(input, sides.second.task)) return out;
  std::vector<Way> first = sides.first.ways, second = sides.second.ways;
  std::vector<ProviderId> losers = clash.losers;
  while (!losers.empty()) {
    const auto is_it = [&](const Way& way) { return way.provider() == losers.front(); };
    out.push_back(name_of(input.model, losers.front()));
    first.erase(std::remove_if(first.begin(), first.end(), is_it), first.end());
    second.erase(std::remove_if(second.begin(), second.end(), is_it), second.end());
    const auto next = PairSearch(input, {{sides.first.task, first}, {sides.second.task, second}}).run();
    if (!next) return out;
    losers = next->losers;
  }
  return {};
}

/// Proposes what leaves each of their providers something: otherwise it would never run.
std::string propose(const Input& input, const Pack& pack, const Sides& sides, const ClashingWays& clash) {
  const Model& model = input.model;
  const Side& first = sides.first;
  const Side& second = sides.second;
  if (std::string help = apart_to_be_pushed(input.model, first.task, second.task); !help.empty()) return help;
  std::vector<std::string> out;
  if (find_superfluous(input, second).empty() &&
      leaves_all(input, second.ways, first.ways, is_requested_elsewhere(input, first.task))) {
    out.push_back(set_apart(model, pack, second.task, first.task));
  } else if (find_superfluous(input, first).empty() &&
             leaves_all(input, first.ways, second.ways, is_requested_elsewhere(input, second.task))) {
    out.push_back(set_apart(model, pack, first.task, second.task));
  }
  const bool of_first =
      std::find(clash.losers.begin(), clash.losers.end(), clash.first->provider()) != clash.losers.end();
  const Side& changed = of_first ? first : second;
  const Side& other = of_first ? second : first;
  const std::string provider = name_of(model, (of_first ? clash.first : clash.second)->provider());
  if (find_superfluous(input, changed).empty() && run_beside(input, changed.ways, other.ways)) {
    std::vector<std::string> groups;
    for (const GroupId each : groups_in_common(*clash.first, *clash.second)) groups.push_back(name_of(model, each));
    out.push_back(
        fmt::format("give {} needs that leave {} to {}", provider, list_of(groups), name_of(model, other.task.target)));
  } else if (const std::vector<std::string> left_out = find_left_out(input, sides, clash); !left_out.empty()) {
    out.push_back(fmt::format("leave {} out", list_of(left_out)));
  }
  std::vector<std::string> superfluous; // alone
  for (const Side* side : {&first, &second}) {
    for (std::string& each : find_superfluous(input, *side)) superfluous.push_back(std::move(each));
  }
  const bool elsewhere = is_requested_elsewhere(input, first.task) || is_requested_elsewhere(input, second.task);
  if (out.empty() || (out.size() == 1 && (superfluous.empty() || !elsewhere)))
    out.push_back("request the two in two packs" +
                  (superfluous.empty() ? "" : fmt::format(" and leave {} out", list_of(superfluous))));
  return fmt::format("{}", fmt::join(out, ", or "));
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
