#pragma once
// SPDX-License-Identifier: MIT
// What the tasks of one of two compared behaviours may take from each other, by names: the ids of the two models are
// unrelated.

#include "compiler/diff/side.hpp"
#include "compiler/graph/topmost.hpp"
#include "compiler/play/coverage/coverage.hpp"

#include <compare>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace director::compiler::diff {

/// One number for each name, on both sides. The names have to outlive it.
class Numbers {
public:
  std::uint32_t of(std::string_view name) {
    return numbers_.try_emplace(name, static_cast<std::uint32_t>(numbers_.size())).first->second;
  }

private:
  std::unordered_map<std::string_view, std::uint32_t> numbers_{{"", 0}};
};

/// Where two tasks may be requested at once, and how they come to claim a group. All of it by the numbers of names.
struct Encounter {
  std::uint32_t mate = 0; ///< a unit is tried at the place of its first member: this one, of the unit of one of the two
  std::uint32_t provider = 0, pack = 0, winner_level = 0, loser_level = 0, mate_level = 0;
  analysis::Reach takes{}, loses{};
  bool is_losers = false; ///< the mate is one of the loser
  bool if_older = false;  ///< at equal priority of mate and rival the mate's request is the older one
  auto operator<=>(const Encounter&) const = default;
};

/// Whether the winner takes the group there. Sorted.
using Encounters = std::vector<std::pair<Encounter, bool>>;

/// Provider, pack and name of the level; for the program only the last.
using Place = std::tuple<std::string, std::string, std::string>;

class TakesByName {
public:
  TakesByName(const Checked& checked, Numbers& numbers);

  /// By requester, "" for the program; in order.
  const std::map<std::string, std::vector<EdgeId>>& edges() const { return edges_; }
  /// Null: there is none.
  const Edge* find(const std::string& requester, const std::string& target) const;

  /// By name of the group for which both may contend.
  using Groups = std::map<std::string_view, Encounters>;
  Groups between(const Edge& winner, const Edge& loser);
  /// Names of the groups that the winner may take; the others come with these.
  std::set<std::string_view> topmost_taken(const Edge& winner, const Edge& loser, const Groups& groups);
  /// Likewise of the groups that both lead to, sorted.
  std::vector<std::string> topmost_common(const Edge& one, const Edge& other);
  /// Whether the two are sometimes compared only while control passes from one pack, provider or requester to another:
  /// they are in different packs, in one unit, or one of them is a need.
  bool meet_in_passing(const Edge& one, const Edge& other) const;

  /// Where the edge is requested, with the index of the level.
  const std::map<Place, std::uint32_t>& places(const Edge& edge) const;

private:
  void add_places(const Task& task, const std::string& provider, const std::string& pack);
  void add(const Rivalry& rivalry, Groups& out);
  void add_mates(const Rivalry& rivalry, Encounter encounter, Encounters& out);
  /// The edges are one table.
  EdgeId id_of(const Edge& edge) const { return {static_cast<std::uint32_t>(&edge - &*model_.edges.begin())}; }
  const Level& level_of(const Task& task, const Task::NamedLevel& level) const {
    return model_.edges[task.edge].levels[level.level];
  }

  const std::vector<bool>& led_to(GroupId from);

  const Model& model_;
  const Graph& graph_;
  Numbers& numbers_;
  Topmost topmost_;
  Rivalries rivalries_;
  std::map<std::string, std::vector<EdgeId>> edges_;
  std::map<std::pair<std::string, std::string>, const Edge*> by_names_;
  std::map<const Edge*, std::map<Place, std::uint32_t>> places_;
  std::map<GroupId, std::vector<bool>> led_to_;
};

} // namespace director::compiler::diff
