// Header: compiler/explore/search/blame.hpp. Test: tests/compiler/explore/verdict_test.cpp.
// SPDX-License-Identifier: MIT
//
// A unit is blocked if for no combination of providers and plans the groups are available (semantics, 4.4, Refuse). So
// the loser's side is to blame if there is a combination once all that it holds counts as available, and none before.
// What others hold is available if the unit goes before them.
#include "compiler/explore/search/blame.hpp"

#include "compiler/explore/search/watch.hpp"
#include "runtime/core/inspect/why.hpp"

#include <algorithm>
#include <vector>

namespace director::compiler {

namespace {

/// Limit for the providers that are tried for one unit.
constexpr int most_tried = 10'000;

class Unit {
public:
  Unit(const Engine& engine, Index edge, Index loser)
      : engine_(engine),
        t_(engine.tables()),
        view_(view_of(engine)),
        edge_(edge),
        loser_(loser) {
    members_.push_back(edge);
    const Index requester = t_.edges[edge].requester;
    if (requester != nil && joins(edge)) {
      const Range siblings = t_.groups[requester].edges;
      for (Index e = siblings.begin; e != siblings.end; ++e) {
        if (e != edge && joins(e)) members_.push_back(e);
      }
    }
    for (const Index member : members_) add_needed(t_.edges[member].target);
  }

  Blame blame() {
    if (std::none_of(needed_.begin(), needed_.end(), [&](Index group) { return loser_holds(group); }))
      return Blame::others;
    const bool before = has_combination(false), without_loser = has_combination(true);
    return tried_ <= most_tried && !before && without_loser ? Blame::loser : Blame::shared;
  }

private:
  /// Needs that are not met yet, those of the last provider first.
  struct Agenda {
    std::span<const Index> edges;
    std::size_t next = 0;
    const Agenda* then = nullptr;
  };

  bool joins(Index edge) const {
    const director::State& s = engine_.memory();
    const Index level = s.request[edge].level;
    return level != nil && !t_.levels[level].optional && !t_.levels[level].apart;
  }

  /// Adds the group and all that it may need, transitively.
  void add_needed(Index target) {
    std::vector<Index> open{target};
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (std::find(needed_.begin(), needed_.end(), open[i]) != needed_.end()) continue;
      needed_.push_back(open[i]);
      for (Index p = t_.groups[open[i]].providers.begin; p != t_.groups[open[i]].providers.end; ++p) {
        for (const Index need : t_.list(t_.providers[p].needs)) open.push_back(t_.edges[need].target);
      }
    }
  }

  /// ... and which blocks the unit.
  bool loser_holds(Index group) const {
    const Index holder = engine_.holder(group);
    return holder != nil && std::find(members_.begin(), members_.end(), holder) == members_.end() &&
           (group == loser_ || under(engine_, holder, loser_)) && stands_in_the_way(view_, holder, edge_);
  }

  bool is_available(Index group, Index edge, bool without_loser) const {
    const Index holder = engine_.holder(group);
    if (holder == nil || holder == edge || !stands_in_the_way(view_, holder, edge_)) return true;
    return without_loser && loser_holds(group);
  }

  bool has_combination(bool without_loser) {
    held_.assign(t_.groups.size(), false);
    const Agenda all{members_, 0, nullptr};
    return meet(&all, without_loser);
  }

  bool meet(const Agenda* agenda, bool without_loser) {
    while (agenda != nullptr && agenda->next == agenda->edges.size()) agenda = agenda->then;
    if (agenda == nullptr) return true;
    const Index edge = agenda->edges[agenda->next], group = t_.edges[edge].target;
    if (held_[group] || !is_available(group, edge, without_loser)) return false;
    held_[group] = true;
    const Agenda rest{agenda->edges, agenda->next + 1, agenda->then};
    bool found = false;
    const Range providers = t_.groups[group].providers;
    for (Index p = providers.begin; p != providers.end && !found && tried_ <= most_tried; ++p) {
      ++tried_;
      const Agenda below{t_.list(t_.providers[p].needs), 0, &rest};
      found = meet(&below, without_loser);
    }
    held_[group] = false;
    return found;
  }

  const Engine& engine_;
  const Tables& t_;
  View view_;
  Index edge_, loser_;
  std::vector<Index> members_, needed_;
  std::vector<bool> held_;
  int tried_ = 0;
};

} // namespace

Blame find_blame(const Engine& engine, Index edge, Index loser) { return Unit(engine, edge, loser).blame(); }

} // namespace director::compiler
