// Header: compiler/diff/side.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
//
// Compares the order of tasks. Two tasks meet below their closest common requester, and the two edges there decide
// (semantics.md, 4.1): so each pair of edges of each requester is compared, over all levels that each may have. The
// order matters if both lead to one group, by requests or needs. An optional task further down is reported by itself,
// as a change of its unit.
#include "compiler/base/and_list.hpp"
#include "compiler/diff/side.hpp"

#include <fmt/format.h>

#include <iterator>
#include <map>

namespace director::compiler::diff {

namespace {

enum Order : unsigned { goes_before = 1, is_equal = 2, goes_after = 4 };

/// The order of all pairs in a model.
class Ranks {
public:
  Ranks(const Model& model, const Graph& graph) : model_(model), graph_(graph), led_to_(model.groups.size()) {
    for (const EdgeId id : model.edges.ids()) {
      const Edge& edge = model.edges[id];
      const std::string requester = edge.requester ? name_of(model, *edge.requester) : "";
      edges_[requester].push_back(id);
      by_names_.emplace(std::pair(requester, name_of(model, edge.target)), &edge);
    }
  }

  const std::map<std::string, std::vector<EdgeId>>& edges() const { return edges_; }
  const Edge* find(const std::string& requester, const std::string& target) const {
    const auto at = by_names_.find({requester, target});
    return at == by_names_.end() ? nullptr : at->second;
  }

  /// The levels of an edge. A need counts as mandatory, with the priority of the first level.
  static std::vector<Level> levels(const Edge& edge) {
    std::vector<Level> out = edge.levels;
    if (edge.needed) out.push_back({out.empty() ? 0 : out.front().priority, false, false});
    return out;
  }
  static unsigned orders(const Edge& one, const Edge& other) {
    unsigned out = 0;
    for (const Level& a : levels(one)) {
      for (const Level& b : levels(other)) {
        if (a.optional != b.optional) out |= a.optional ? goes_after : goes_before;
        if (a.optional == b.optional)
          out |= a.priority > b.priority ? goes_before : a.priority < b.priority ? goes_after : is_equal;
      }
    }
    return out;
  }

  /// Names of the groups that both lead to. `top`: without the groups below these.
  std::vector<std::string> over(const Edge& one, const Edge& other, bool top) {
    const std::vector<bool>&first = led_to(one.target), &second = led_to(other.target);
    std::vector<std::string> out;
    for (const GroupId id : top ? contested(model_, first, second) : model_.groups.ids()) {
      if (first[id.value] && second[id.value]) out.push_back(name_of(model_, id));
    }
    std::sort(out.begin(), out.end());
    return out;
  }

  /// Names of all groups below a group, and its own.
  std::set<std::string> reach(GroupId from) {
    const std::vector<bool>& below = led_to(from);
    std::set<std::string> out;
    for (const GroupId id : model_.groups.ids()) {
      if (below[id.value]) out.insert(name_of(model_, id));
    }
    return out;
  }

private:
  const std::vector<bool>& led_to(GroupId from) {
    std::vector<bool>& out = led_to_[from.value];
    if (out.empty()) out = compiler::led_to(graph_, from);
    return out;
  }

  const Model& model_;
  const Graph& graph_;
  std::map<std::string, std::vector<EdgeId>> edges_; ///< by requester, "" for the program; in order
  std::map<std::pair<std::string, std::string>, const Edge*> by_names_;
  std::vector<std::vector<bool>> led_to_;
};

std::string rank_text(const Edge& edge) {
  std::vector<std::string> out;
  if (edge.levels.empty()) return "needed only";
  for (const Level& level : edge.levels)
    out.push_back(fmt::format("{}{}", level.optional ? "optional, " : "", level.priority));
  return "priority " + and_list(out);
}

class Comparison {
public:
  Comparison(const Pair& pair, Changes& changes)
      : pair_(pair),
        changes_(changes),
        old_(pair.old_model, pair.before.graph),
        new_(pair.new_model, pair.after.graph) {}

  void compare() {
    for (const auto& [requester, edges] : new_.edges()) {
      const bool known = requester.empty() || pair_.old_model.find_group(requester);
      if (!known) continue;
      pairs_.clear();
      for (const EdgeId id : edges) {
        const Edge& edge = pair_.new_model.edges[id];
        pairs_.emplace_back(&edge, old_.find(requester, target(edge)));
      }
      // Skips two unchanged edges: most requesters of most changes have only these.
      std::vector<std::pair<const Edge*, const Edge*>> changed;
      std::copy_if(pairs_.begin(), pairs_.end(), std::back_inserter(changed),
                   [&](const auto& each) { return !is_alike(each); });
      for (const auto& [winner, old_winner] : pairs_)
        losers_of(*winner, old_winner, is_alike({winner, old_winner}) ? changed : pairs_);
      ties(requester);
    }
    for (const auto& [requester, edges] : new_.edges()) {
      for (const EdgeId id : edges) number(requester, pair_.new_model.edges[id]);
    }
  }

private:
  using Names = std::vector<std::string>;
  /// For one winner and one wording: the losers.
  struct Losers {
    Names losers;
    Span before{}, after{};
  };

  std::string target(const Edge& edge) const { return name_of(pair_.new_model, edge.target); }

  /// Whether it leads to the same groups as before.
  bool leads_alike(const Edge& edge, const Edge& old) {
    const auto [at, fresh] = alike_.try_emplace(edge.target, false);
    if (fresh) at->second = new_.reach(edge.target) == old_.reach(old.target);
    return at->second;
  }

  bool is_alike(const std::pair<const Edge*, const Edge*>& each) {
    const auto& [edge, old] = each;
    return old != nullptr && edge->levels == old->levels && edge->needed == old->needed && leads_alike(*edge, *old);
  }

  void losers_of(const Edge& winner, const Edge* old_winner,
                 const std::vector<std::pair<const Edge*, const Edge*>>& others) {
    std::map<std::pair<Names, std::string>, Losers> gained, lost, always, sometimes;
    for (const auto& [other, old_loser] : others) {
      const Edge& loser = *other;
      if (&loser == &winner || old_loser == nullptr) continue;
      const unsigned now = Ranks::orders(winner, loser),
                     before = old_winner == nullptr ? 0 : Ranks::orders(*old_winner, *old_loser);
      const bool can = (now & goes_before) != 0, could = (before & goes_before) != 0;
      if (!can && !could) continue;
      const std::string why = reason(winner, old_winner, loser, *old_loser);
      const Names none;
      const Names more = missing_in(can ? new_.over(winner, loser, true) : none,
                                    could ? old_.over(*old_winner, *old_loser, false) : none);
      const Names less = missing_in(could ? old_.over(*old_winner, *old_loser, true) : none,
                                    can ? new_.over(winner, loser, false) : none);
      if (!more.empty()) collect(gained, more, why, winner, old_winner, loser, *old_loser);
      if (!less.empty()) collect(lost, less, why, winner, old_winner, loser, *old_loser);
      // With all of its levels against all of the other's, or only with some.
      if (!can || !could || !more.empty() || !less.empty() || (now == goes_before) == (before == goes_before)) continue;
      const Names over = new_.over(winner, loser, true);
      if (!over.empty())
        collect(now == goes_before ? always : sometimes, over, why, winner, old_winner, loser, *old_loser);
    }
    for (const auto& [what, losers] : gained) add(ChangeKind::takeover_gained, "can now", winner, what, losers);
    for (const auto& [what, losers] : always) add(ChangeKind::takeover_gained, "can now always", winner, what, losers);
    for (const auto& [what, losers] : lost) add(ChangeKind::takeover_lost, "can no longer", winner, what, losers);
    for (const auto& [what, losers] : sometimes)
      add(ChangeKind::takeover_lost, "can no longer always", winner, what, losers);
  }

  std::string reason(const Edge& winner, const Edge* old_winner, const Edge& loser, const Edge& old_loser) const {
    const std::string by = requester_name(pair_.new_model, winner.requester);
    if (old_winner == nullptr) return fmt::format("{} requests it now, with {}", by, rank_text(winner));
    if (Ranks::orders(winner, loser) == Ranks::orders(*old_winner, old_loser))
      return fmt::format("below {} the one goes before the other as it did; what they lead to has changed", by);
    if (winner.levels != old_winner->levels)
      return fmt::format("{} requests it with {}, before with {}", by, rank_text(winner), rank_text(*old_winner));
    return fmt::format("{} requests `{}` with {}, before with {}", by, target(loser), rank_text(loser),
                       rank_text(old_loser));
  }

  void collect(std::map<std::pair<Names, std::string>, Losers>& all, const Names& over, const std::string& why,
               const Edge& winner, const Edge* old_winner, const Edge& loser, const Edge& old_loser) {
    Losers& losers = all[{over, why}];
    losers.losers.push_back(target(loser));
    // The place is that of the changed side.
    const bool by_loser = old_winner != nullptr && winner.levels == old_winner->levels;
    losers.before = by_loser || old_winner == nullptr ? old_loser.span : old_winner->span;
    losers.after = by_loser ? loser.span : winner.span;
    explained_.insert(edge_name(winner));
    explained_.insert(edge_name(loser));
  }

  std::string edge_name(const Edge& edge) const {
    return (edge.requester ? name_of(pair_.new_model, *edge.requester) : "root") + ">" + target(edge);
  }

  void add(ChangeKind kind, const char* how, const Edge& winner, const std::pair<Names, std::string>& what,
           const Losers& losers) {
    const bool itself = what.first == Names{target(winner)};
    changes_.add(kind, edge_name(winner),
                 fmt::format("`{}` {} take {} from {}: {}", target(winner), how,
                             itself ? "the place" : ticked_list(what.first), ticked_list(losers.losers), what.second),
                 losers.before, losers.after);
  }

  /// With equal rank the earlier declaration goes first.
  void ties(const std::string& requester) {
    Names was, is;
    std::set<std::string> flipped;
    const auto at = old_.edges().find(requester);
    if (at == old_.edges().end()) return;
    const Edge *first_old = nullptr, *first_new = nullptr, *last = nullptr;
    bool sorted = true; // the old edges are one table: addresses have its order
    for (const auto& [edge, old] : pairs_) {
      if (old == nullptr) continue;
      sorted = sorted && last <= old;
      last = old;
    }
    if (sorted) return;
    const std::vector<EdgeId>& edges = new_.edges().at(requester);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      for (std::size_t k = i + 1; k < pairs_.size(); ++k) {
        const Edge &one = *pairs_[i].first, &other = *pairs_[k].first;
        const Edge *const old_one = pairs_[i].second, *const old_other = pairs_[k].second;
        // An edge that is only needed is claimed with the rest of its plan, or is younger than a request.
        if (one.levels.empty() || other.levels.empty()) continue;
        if (old_one == nullptr || old_other == nullptr || old_one < old_other)
          continue; // one table: addresses have its order
        if ((Ranks::orders(one, other) & is_equal) == 0 || (Ranks::orders(*old_one, *old_other) & is_equal) == 0)
          continue;
        flipped.insert(target(one));
        flipped.insert(target(other));
        if (first_new == nullptr) first_new = &one, first_old = old_one;
      }
    }
    if (flipped.empty()) return;
    for (const EdgeId id : at->second) {
      const std::string& name = name_of(pair_.old_model, pair_.old_model.edges[id].target);
      if (flipped.count(name) != 0) was.push_back(name);
    }
    for (const EdgeId id : edges) {
      if (flipped.count(target(pair_.new_model.edges[id])) != 0) is.push_back(target(pair_.new_model.edges[id]));
    }
    changes_.add(ChangeKind::tie_order, requester.empty() ? "root" : requester,
                 fmt::format("of what {} requests at one rank, the order is {}, before {}: the first one wins where "
                             "they are requested at once",
                             requester.empty() ? std::string("the program") : ticked(requester), ticked_list(is),
                             ticked_list(was)),
                 first_old->span, first_new->span);
  }

  /// Edges with another rank that changed no order.
  void number(const std::string& requester, const Edge& edge) {
    const Edge* const old = old_.find(requester, target(edge));
    if (old == nullptr || explained_.count(edge_name(edge)) != 0) return;
    const auto ranks = [](const Edge& each) {
      std::multiset<std::int32_t> out;
      for (const Level& level : each.levels) out.insert(level.priority);
      return out;
    };
    if (ranks(edge) == ranks(*old) || edge.levels.empty() || old->levels.empty()) return;
    changes_.add(
        ChangeKind::priority, edge_name(edge),
        fmt::format("{} requests `{}` with {}, before with {}; what each can take from the others is as before",
                    requester_name(pair_.new_model, edge.requester), target(edge), rank_text(edge), rank_text(*old)),
        old->span, edge.span);
  }

  const Pair& pair_;
  Changes& changes_;
  Ranks old_, new_;
  std::vector<std::pair<const Edge*, const Edge*>> pairs_; ///< of one requester: the new edge, and the old one or null
  std::map<GroupId, bool> alike_;
  std::set<std::string> explained_;
};

} // namespace

void compare_ranks(const Pair& pair, Changes& changes) { Comparison(pair, changes).compare(); }

} // namespace director::compiler::diff
