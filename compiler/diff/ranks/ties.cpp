// Header: compiler/diff/ranks/ties.hpp. Test: tests/compiler/diff/ranks/order_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/diff/ranks/ties.hpp"

#include "compiler/base/list_of.hpp"
#include "compiler/diff/ranks/stakes.hpp"

#include <fmt/format.h>

#include <memory>
#include <set>

namespace director::compiler::diff {

namespace {

/// Both sides of one edge of a requester.
struct Same {
  const Edge *before = nullptr, *after = nullptr;
};

class Ties {
public:
  Ties(const Pair& pair, const TakesByName& before, const TakesByName& after, Changes& changes)
      : pair_(pair),
        before_(before),
        after_(after),
        topmost_(pair.after.graph),
        changes_(changes) {}

  void compare(const std::string& requester, const std::vector<EdgeId>& edges) {
    std::vector<Same> all; // in the new order
    for (const EdgeId id : edges) {
      const Edge& edge = pair_.new_model.edges[id];
      const Edge* const old = before_.find(requester, name_of(pair_.new_model, edge.target));
      // An edge that is only needed is claimed with the rest of its plan, or is younger than a request.
      if (old != nullptr && !edge.levels.empty() && !old->levels.empty()) all.push_back({old, &edge});
    }
    const auto by_old = [](const Same& a, const Same& b) { return a.before < b.before; }; // one table
    if (std::is_sorted(all.begin(), all.end(), by_old)) return;
    std::set<const Edge*> flipped;
    std::set<std::string> groups, pushed;
    const Same* first = nullptr;
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = i + 1; k < all.size(); ++k) {
        if (by_old(all[i], all[k]) || !decides(all[i], all[k], groups, pushed)) continue;
        flipped.insert({all[i].after, all[k].after});
        if (first == nullptr) first = &all[i];
      }
    }
    if (first == nullptr) return;
    std::erase_if(all, [&](const Same& each) { return flipped.count(each.after) == 0; });
    const Same place = all.front();
    const std::vector<std::string> is = names(all);
    std::sort(all.begin(), all.end(), by_old);
    changes_.add(ChangeKind::tie_order, requester.empty() ? "root" : requester,
                 fmt::format("of what {} requests at one priority, the order is {}, before {}: of those that were "
                             "requested at once, {}",
                             requester.empty() ? std::string("the program") : ticked(requester), ticked_list(is),
                             ticked_list(names(all)), outcome(groups, pushed)),
                 place.before->span, place.after->span);
  }

private:
  std::vector<std::string> names(const std::vector<Same>& all) const {
    std::vector<std::string> out;
    for (const Same& each : all) out.push_back(name_of(pair_.new_model, each.after->target));
    return out;
  }

  static std::string outcome(const std::set<std::string>& groups, const std::set<std::string>& pushed) {
    std::vector<std::string> out;
    if (!groups.empty()) out.push_back(fmt::format("the first one that wants {} gets it", few(groups, "or")));
    if (!pushed.empty())
      out.push_back(fmt::format("the first one that pushes a provider of {} decides which", few(pushed, "or")));
    return list_of(out);
  }

  /// Whether the order of these two decides something on both sides.
  bool decides(const Same& one, const Same& other, std::set<std::string>& groups, std::set<std::string>& pushed) {
    if (!was_) {
      was_ = std::make_unique<Stakes>(pair_.before, pair_.possible_before, before_);
      is_ = std::make_unique<Stakes>(pair_.after, pair_.possible_after, after_);
    }
    const Stake is = is_->between(*one.after, *other.after);
    if (is.empty() || was_->between(*one.before, *other.before).empty()) return false;
    for (const GroupId id : topmost_.of(one.after->target, other.after->target, is.groups))
      groups.insert(name_of(pair_.new_model, id));
    pushed.insert(is.pushed.begin(), is.pushed.end());
    return true;
  }

  const Pair& pair_;
  const TakesByName &before_, &after_;
  std::unique_ptr<Stakes> was_, is_; ///< computed where an order has changed
  Topmost topmost_;
  Changes& changes_;
};

} // namespace

void compare_ties(const Pair& pair, const TakesByName& before, const TakesByName& after, Changes& changes) {
  Ties ties(pair, before, after, changes);
  for (const auto& [requester, edges] : after.edges()) ties.compare(requester, edges);
}

} // namespace director::compiler::diff
