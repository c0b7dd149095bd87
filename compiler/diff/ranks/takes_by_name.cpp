// Header: compiler/diff/ranks/takes_by_name.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/diff/ranks/takes_by_name.hpp"

#include "compiler/analysis/chains/unit_places.hpp"

#include <algorithm>

namespace director::compiler::diff {

TakesByName::TakesByName(const Checked& checked, Numbers& numbers)
    : model_(checked.model),
      graph_(checked.graph),
      numbers_(numbers),
      topmost_(checked.graph),
      rivalries_(checked.model, checked.graph) {
  for (const EdgeId id : model_.edges.ids()) {
    const Edge& edge = model_.edges[id];
    const std::string requester = edge.requester ? name_of(model_, *edge.requester) : "";
    edges_[requester].push_back(id);
    by_names_.emplace(std::pair(requester, name_of(model_, edge.target)), &edge);
  }
  for (const Task& task : model_.roots) add_places(task, "", "");
  for (const ProviderId id : model_.providers.ids()) {
    for (const Pack& pack : model_.providers[id].packs) {
      for (const Task& task : pack.tasks) add_places(task, model_.full_name(id), pack.name);
    }
  }
}

const Edge* TakesByName::find(const std::string& requester, const std::string& target) const {
  const auto at = by_names_.find({requester, target});
  return at == by_names_.end() ? nullptr : at->second;
}

TakesByName::Groups TakesByName::between(const Edge& winner, const Edge& loser) {
  Groups out;
  rivalries_.between(id_of(winner), id_of(loser), [&](const Rivalry& each) { add(each, out); });
  for (auto& [group, encounters] : out) std::sort(encounters.begin(), encounters.end());
  return out;
}

std::set<std::string_view> TakesByName::topmost_taken(const Edge& winner, const Edge& loser, const Groups& groups) {
  std::vector<bool> taken(model_.groups.size());
  for (const auto& [name, encounters] : groups) {
    if (std::any_of(encounters.begin(), encounters.end(), [](const auto& each) { return each.second; }))
      taken[model_.find_group(std::string(name))->value] = true;
  }
  std::set<std::string_view> out;
  for (const GroupId id : topmost_.of(winner.target, loser.target, taken)) out.insert(name_of(model_, id));
  return out;
}

std::vector<std::string> TakesByName::topmost_common(const Edge& one, const Edge& other) {
  std::vector<bool> common = led_to(one.target);
  const std::vector<bool>& others = led_to(other.target);
  for (std::size_t i = 0; i < common.size(); ++i) common[i] = common[i] && others[i];
  std::vector<std::string> out;
  for (const GroupId id : topmost_.of(one.target, other.target, common)) out.push_back(name_of(model_, id));
  std::sort(out.begin(), out.end());
  return out;
}

bool TakesByName::meet_in_passing(const Edge& one, const Edge& other) const {
  if (!one.requester) return false;
  if (one.needed || other.needed) return true;
  for (const auto& [first, level] : places(one)) {
    for (const auto& [second, others] : places(other)) {
      const bool is_one_pack = std::get<0>(first) == std::get<0>(second) && std::get<1>(first) == std::get<1>(second);
      if (!is_one_pack || (one.levels[level].shares_unit() && other.levels[others].shares_unit())) return true;
    }
  }
  return false;
}

const std::vector<bool>& TakesByName::led_to(GroupId from) {
  std::vector<bool>& out = led_to_[from];
  if (out.empty()) out = compiler::led_to(graph_, from);
  return out;
}

const std::map<Place, std::uint32_t>& TakesByName::places(const Edge& edge) const {
  static const std::map<Place, std::uint32_t> none;
  const auto at = places_.find(&edge);
  return at == places_.end() ? none : at->second;
}

void TakesByName::add_places(const Task& task, const std::string& provider, const std::string& pack) {
  for (const Task::NamedLevel& level : task.levels)
    places_[&model_.edges[task.edge]].emplace(Place{provider, pack, level.name}, level.level);
}

void TakesByName::add(const Rivalry& rivalry, Groups& groups) {
  Encounters& out = groups[name_of(model_, rivalry.group)];
  Encounter encounter;
  if (rivalry.provider) encounter.provider = numbers_.of(model_.providers[*rivalry.provider].name);
  encounter.pack = numbers_.of(rivalry.pack);
  encounter.winner_level = numbers_.of(rivalry.taker_level->name);
  encounter.loser_level = numbers_.of(rivalry.loser_level->name);
  encounter.takes = rivalry.takes;
  encounter.loses = rivalry.loses;
  out.emplace_back(encounter, rivalry.wins);
  if (rivalry.provider) add_mates(rivalry, encounter, out);
}

/// The same with each member of a unit that brings one of the two forward, if the other one is apart (semantics.md,
/// 4.4): that which is granted with the unit, not what its members request.
void TakesByName::add_mates(const Rivalry& rivalry, Encounter encounter, Encounters& out) {
  const Level &winner = level_of(*rivalry.taker, *rivalry.taker_level),
              &loser = level_of(*rivalry.loser, *rivalry.loser_level);
  const auto is_led = [](const Level& level, analysis::Reach reach, const Level& rival) {
    return reach == analysis::Reach::own && analysis::is_placed(level, rival);
  };
  encounter.is_losers = is_led(loser, rivalry.loses, winner);
  if (!encounter.is_losers && !is_led(winner, rivalry.takes, loser)) return;
  const std::int32_t rivals = encounter.is_losers ? winner.priority : loser.priority;
  for (const analysis::Mate& mate :
       analysis::mates_of(model_, *rivalry.entries, rivalry.taker->edge, rivalry.loser->edge)) {
    encounter.mate = numbers_.of(name_of(model_, mate.task->target));
    encounter.mate_level = numbers_.of(mate.level->name);
    for (const bool if_older : {false, true}) {
      encounter.if_older = if_older;
      const bool leads = mate.priority > rivals || (if_older && mate.priority == rivals);
      out.emplace_back(encounter, encounter.is_losers ? rivalry.wins && !leads : rivalry.wins || leads);
    }
  }
}

} // namespace director::compiler::diff
