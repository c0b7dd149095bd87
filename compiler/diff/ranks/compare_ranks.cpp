// Header: compiler/diff/side.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
//
// Compares what tasks can take from each other. Two tasks meet below their closest common requester, and the two edges
// there decide (semantics.md, 4.1). So for each pair of edges of each requester, the rivalries of both sides are
// compared, which pages and coverage use too: each pair of their levels, each group that both may claim then, and how.
// Where a level is requested, and its name, say which levels of the two sides are the same.
#include "compiler/base/list_of.hpp"
#include "compiler/diff/ranks/ranks.hpp"
#include "compiler/diff/ranks/shifts.hpp"
#include "compiler/diff/ranks/takes_by_name.hpp"
#include "compiler/diff/ranks/ties.hpp"
#include "compiler/diff/side.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

namespace director::compiler::diff {

namespace {

/// "`Watch` in pack `far` at `calm`"
std::string words_of(const Place& place) {
  const auto& [provider, pack, level] = place;
  std::string out = provider.empty() ? "the program" : ticked(provider);
  if (!pack.empty()) out += " in pack " + ticked(pack);
  if (!level.empty()) out += " at " + ticked(level);
  return out;
}

class Comparison {
public:
  Comparison(const Pair& pair, Changes& changes)
      : pair_(pair),
        changes_(changes),
        old_(pair.before, numbers_),
        new_(pair.after, numbers_) {}

  void compare() {
    for (const auto& [requester, edges] : new_.edges()) {
      const bool known = requester.empty() || pair_.old_model.find_group(requester);
      if (!known) continue;
      pairs_.clear();
      for (const EdgeId id : edges) {
        const Edge& edge = pair_.new_model.edges[id];
        pairs_.emplace_back(&edge, old_.find(requester, target(edge)));
      }
      for (const auto& [winner, old_winner] : pairs_) losers_of(*winner, old_winner);
    }
    for (const auto& [requester, edges] : new_.edges()) {
      for (const EdgeId id : edges) number(requester, pair_.new_model.edges[id]);
    }
    compare_ties(pair_, old_, new_, changes_);
  }

private:
  using Names = std::vector<std::string>;
  /// For one winner and one wording: the losers.
  struct Losers {
    Names losers;
    Span before{}, after{};
  };
  using Wordings = std::map<std::tuple<Shift, Names, std::string>, Losers>;

  std::string target(const Edge& edge) const { return name_of(pair_.new_model, edge.target); }

  void losers_of(const Edge& winner, const Edge* old_winner) {
    Wordings wordings;
    for (const auto& [other, old_loser] : pairs_) {
      const Edge& loser = *other;
      if (&loser == &winner || old_loser == nullptr) continue;
      const TakesByName::Groups now = new_.between(winner, loser), before = old_winner == nullptr
                                                                                ? TakesByName::Groups{}
                                                                                : old_.between(*old_winner, *old_loser);
      const bool is_reported =
          now != before && compare_contest(winner, old_winner, loser, *old_loser, before, now, wordings);
      if (!is_reported && old_winner != nullptr) compare_in_passing(winner, *old_winner, loser, *old_loser, wordings);
    }
    for (const auto& [wording, losers] : wordings) {
      const auto& [shift, groups, why] = wording;
      changes_.add(kind_of(shift), edge_name(winner),
                   sentence(shift, ticked(target(winner)), taken(groups, target(winner), losers.losers)) + ": " + why,
                   losers.before, losers.after);
    }
  }

  /// "`Legs` from `Walk`"
  static std::string taken(const Names& groups, const std::string& winner, const Names& losers) {
    if (groups == Names{winner}) return "the place of " + ticked_list(losers);
    return groups == losers ? ticked_list(groups) + (losers.size() == 1 ? " itself" : " themselves")
                            : fmt::format("{} from {}", ticked_list(groups), ticked_list(losers));
  }

  /// What is never requested at once is compared, too, while control passes from the one to the other.
  void compare_in_passing(const Edge& winner, const Edge& old_winner, const Edge& loser, const Edge& old_loser,
                          Wordings& out) {
    if (is_order_alike(winner, old_winner, loser, old_loser)) return;
    if (!new_.meet_in_passing(winner, loser) || !old_.meet_in_passing(old_winner, old_loser)) return;
    const auto [gains, loses] = gains_and_loses(orders(old_winner, old_loser), orders(winner, loser));
    if (!gains && !loses) return;
    const Names names = new_.topmost_common(winner, loser);
    if (names.empty() || old_.topmost_common(old_winner, old_loser).empty()) return;
    const std::string why = reason(winner, &old_winner, loser, old_loser);
    const bool by_loser = winner.levels == old_winner.levels;
    for (const Shift shift : {Shift::more_in_passing, Shift::fewer_in_passing}) {
      if (shift == Shift::more_in_passing ? !gains : !loses) continue;
      Losers& losers = out[{shift, names, why}];
      losers.losers.push_back(target(loser));
      losers.before = by_loser ? old_loser.span : old_winner.span;
      losers.after = by_loser ? loser.span : winner.span;
    }
    explained_.insert({edge_name(winner), edge_name(loser)});
  }

  /// Whether a change was reported.
  bool compare_contest(const Edge& winner, const Edge* old_winner, const Edge& loser, const Edge& old_loser,
                       const TakesByName::Groups& before, const TakesByName::Groups& now, Wordings& out) {
    static const Encounters none;
    std::map<std::pair<Shift, Mate>, std::set<std::string_view>> shifted; // with the mate that is the reason
    const auto compare = [&](std::string_view group, const Encounters& was, const Encounters& is) {
      const std::vector<Shift> all = shifts(was, is);
      for (const Shift each : all) shifted[{each, differing_mate(was, is)}].insert(group);
    };
    for (const auto& [group, is] : now) {
      const auto was = before.find(group);
      compare(group, was == before.end() ? none : was->second, is);
    }
    for (const auto& [group, was] : before) {
      if (!now.contains(group)) compare(group, was, none);
    }
    if (shifted.empty()) return false;
    bool is_reported = false;
    const std::set<std::string_view> top = new_.topmost_taken(winner, loser, now),
                                     old_top = old_winner == nullptr
                                                   ? std::set<std::string_view>{}
                                                   : old_.topmost_taken(*old_winner, old_loser, before);
    for (const auto& [what, groups] : shifted) {
      const auto& [shift, mate] = what;
      const auto& from = kind_of(shift) == ChangeKind::takeover_gained ? top : old_top;
      Names names;
      for (const std::string_view group : groups) {
        if (from.contains(group)) names.emplace_back(group);
      }
      is_reported = is_reported || !names.empty();
      if (names.empty()) continue; // it comes with a group that can be taken as before
      const std::pair<const Edge*, const Edge*> brought = mate.name == 0 ? std::pair{nullptr, nullptr} : changed(mate);
      Losers& losers = out[{shift, names,
                            mate.name == 0 ? reason(winner, old_winner, loser, old_loser)
                                           : mates_reason(brought, target(mate.is_losers ? loser : winner))}];
      losers.losers.push_back(target(loser));
      // The place is that of the changed side.
      const bool by_loser = old_winner != nullptr && winner.levels == old_winner->levels;
      const auto& [cause, old_cause] = brought.first != nullptr ? brought
                                       : by_loser || old_winner == nullptr
                                           ? std::pair{by_loser ? &loser : &winner, &old_loser}
                                           : std::pair{&winner, old_winner};
      losers.before = old_cause->span;
      losers.after = cause->span;
      if (brought.first != nullptr) explained_.insert(edge_name(*brought.first));
      explained_.insert({edge_name(winner), edge_name(loser)});
    }
    return is_reported;
  }

  std::string reason(const Edge& winner, const Edge* old_winner, const Edge& loser, const Edge& old_loser) {
    const std::string by = requester_name(pair_.new_model, winner.requester);
    if (old_winner == nullptr) return fmt::format("{} requests it now, with {}", by, rank_text(winner));
    const auto ranks = [&](const Edge& edge, const Edge& old) {
      return fmt::format("{} requests `{}` with {}, before with {}", by, target(edge), rank_text(edge), rank_text(old));
    };
    if (std::string why = lives_otherwise(winner, *old_winner, loser, old_loser); !why.empty()) {
      for (const auto& [edge, old] : {std::pair(&winner, old_winner), {&loser, &old_loser}}) {
        if (edge->levels != old->levels) why += "; " + ranks(*edge, *old);
      }
      return why;
    }
    if (is_order_alike(winner, *old_winner, loser, old_loser)) {
      for (const std::string& moved : {moved_levels(winner, *old_winner), moved_levels(loser, old_loser)}) {
        if (!moved.empty()) return moved;
      }
      return fmt::format("below {} the one goes before the other as it did; {}", by,
                         leads_alike(winner, *old_winner) && leads_alike(loser, old_loser)
                             ? "when they lead there, or how, has changed"
                             : "what they lead to has changed");
    }
    if (winner.levels != old_winner->levels)
      return fmt::format("{} requests it with {}, before with {}", by, rank_text(winner), rank_text(*old_winner));
    return ranks(loser, old_loser);
  }

  /// If one of them could run before and never can now, or the other way round; else empty.
  std::string lives_otherwise(const Edge& winner, const Edge& old_winner, const Edge& loser,
                              const Edge& old_loser) const {
    if (!pair_.old_model.deployment || !pair_.new_model.deployment) return {};
    for (const auto& [edge, old] : {std::pair(&winner, &old_winner), {&loser, &old_loser}}) {
      const bool could = pair_.old_model.has_any(old->target, pair_.possible_before.facts().active),
                 can = pair_.new_model.has_any(edge->target, pair_.possible_after.facts().active);
      if (could != can)
        return fmt::format("{} {}", ticked(target(*edge)), can ? "could never run before" : "can never run any more");
    }
    return {};
  }

  /// Where the target is requested, if two of these places are in another order than before: "the program at `calm`
  /// requests `Walk` with priority 9, before with 1".
  std::string moved_levels(const Edge& edge, const Edge& old) {
    std::vector<std::string> out;
    std::vector<std::pair<std::int32_t, std::int32_t>> priorities; // before, now
    const std::map<Place, std::uint32_t>& before = old_.places(old);
    for (const auto& [place, level] : new_.places(edge)) {
      const auto was = before.find(place);
      if (was == before.end()) continue;
      const auto& [then, now] = priorities.emplace_back(old.levels[was->second].priority, edge.levels[level].priority);
      if (now != then)
        out.push_back(
            fmt::format("{} requests `{}` with priority {}, before with {}", words_of(place), target(edge), now, then));
    }
    std::sort(priorities.begin(), priorities.end());
    const bool in_order = std::is_sorted(priorities.begin(), priorities.end(),
                                         [](const auto& a, const auto& b) { return a.second < b.second; });
    return in_order ? "" : list_of(out);
  }

  /// The edge of a mate on both sides, if its levels have changed; else nulls.
  std::pair<const Edge*, const Edge*> changed(const Mate& mate) {
    for (const auto& [edge, old] : pairs_) {
      if (numbers_.of(name_of(pair_.new_model, edge->target)) != mate.name) continue;
      if (old != nullptr && edge->levels != old->levels) return {edge, old};
    }
    return {nullptr, nullptr};
  }

  std::string mates_reason(const std::pair<const Edge*, const Edge*>& mate, const std::string& member) const {
    const auto& [edge, old] = mate;
    if (edge == nullptr) return fmt::format("what may be granted together with `{}` has changed", member);
    return fmt::format("{} requests `{}`, which may be granted together with `{}`, with {}, before with {}",
                       requester_name(pair_.new_model, edge->requester), target(*edge), member, rank_text(*edge),
                       rank_text(*old));
  }

  /// Whether it leads to the same groups as before.
  bool leads_alike(const Edge& edge, const Edge& old) {
    const auto [at, fresh] = alike_.try_emplace(edge.target, false);
    if (fresh)
      at->second = reach(pair_.new_model, pair_.after.graph, edge.target) ==
                   reach(pair_.old_model, pair_.before.graph, old.target);
    return at->second;
  }

  static std::set<std::string> reach(const Model& model, const Graph& graph, GroupId from) {
    const std::vector<bool> below = led_to(graph, from);
    std::set<std::string> out;
    for (const GroupId id : model.groups.ids()) {
      if (below[id.value]) out.insert(name_of(model, id));
    }
    return out;
  }

  std::string edge_name(const Edge& edge) const {
    return (edge.requester ? name_of(pair_.new_model, *edge.requester) : "root") + ">" + target(edge);
  }

  /// Edges with another rank that changed nothing of the above.
  void number(const std::string& requester, const Edge& edge) {
    const Edge* const old = old_.find(requester, target(edge));
    if (old == nullptr) return;
    /// Where both sides request it.
    std::vector<std::pair<const Place*, std::pair<std::uint32_t, std::uint32_t>>> places;
    const std::map<Place, std::uint32_t>& before = old_.places(*old);
    bool differs = false;
    for (const auto& [place, level] : new_.places(edge)) {
      const auto was = before.find(place);
      if (was == before.end()) continue;
      places.push_back({&place, {was->second, level}});
      differs = differs || edge.levels[level].priority != old->levels[was->second].priority;
    }
    keeps(edge, *old, places);
    if (!differs || explained_.contains(edge_name(edge))) return;
    changes_.add(ChangeKind::priority, edge_name(edge),
                 fmt::format("{} requests `{}` with {}, before with {}; what each can take from the others {}",
                             requester_name(pair_.new_model, edge.requester), target(edge), rank_text(edge),
                             rank_text(*old),
                             pair_.new_model.deployment && pair_.old_model.deployment
                                 ? "is as before, but their bodies run by priority where they are granted at once"
                                 : "is compared only in a behaviour with `roots`"),
                 old->span, edge.span);
  }

  /// A request marked `keep` keeps what was requested at the same level.
  void keeps(const Edge& edge, const Edge& old,
             const std::vector<std::pair<const Place*, std::pair<std::uint32_t, std::uint32_t>>>& places) {
    for (const bool now : {true, false}) {
      for (std::size_t i = 0; i < places.size(); ++i) {
        const auto& [first, levels] = places[i];
        const auto at =
            std::find_if(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(i), [&](const auto& each) {
              const bool was = each.second.first == levels.first, is = each.second.second == levels.second;
              return was != is && is == now;
            });
        if (at == places.begin() + static_cast<std::ptrdiff_t>(i)) continue;
        changes_.add(
            ChangeKind::levels, edge_name(edge),
            fmt::format(
                "`{}` is requested with {}, before with {}: marked *keep*, a request by {} {} what was requested by "
                "{}, as their levels {}",
                target(edge), rank_text(edge), rank_text(old), words_of(*first), now ? "now keeps" : "no longer keeps",
                words_of(*at->first), now ? "are the same" : "differ"),
            old.span, edge.span);
        break;
      }
    }
  }

  const Pair& pair_;
  Changes& changes_;
  Numbers numbers_;
  TakesByName old_, new_;
  std::vector<std::pair<const Edge*, const Edge*>> pairs_; ///< of one requester: the new edge, and the old one or null
  std::map<GroupId, bool> alike_;
  std::set<std::string> explained_; ///< edges of the changes that were found
};

} // namespace

void compare_ranks(const Pair& pair, Changes& changes) { Comparison(pair, changes).compare(); }

} // namespace director::compiler::diff
