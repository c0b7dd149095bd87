// Header: compiler/diff/ranks/stakes.hpp. Test: tests/compiler/diff/ranks/order_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/diff/ranks/stakes.hpp"

#include "compiler/analysis/facts/facts.hpp"

#include <algorithm>
#include <tuple>

namespace director::compiler::diff {

using analysis::Reach;

Stakes::Stakes(const Checked& checked, const Possible& possible, const TakesByName& takes)
    : model_(checked.model),
      graph_(checked.graph),
      takes_(takes),
      is_closed_(checked.model.deployment),
      facts_(possible.facts()),
      branches_(checked.model, {[this](ProviderId id) {
                                  return !is_closed_ || (facts_.capable.contains(id) &&
                                                         facts_.requested.contains(model_.providers[id].group));
                                },
                                [this](ProviderId id) { return !is_closed_ || facts_.capable.contains(id); },
                                [this](ProviderId id) { return !is_closed_ || facts_.pushed.contains(id); },
                                analysis::Requested::by_group}),
      pushes_(possible.pushes()) {}

bool Stakes::has_choice(GroupId task) const {
  std::vector<bool> held = reachable(graph_.needs, task.value);
  held[task.value] = true;
  const std::vector<GroupId> all = model_.groups.ids();
  return std::any_of(all.begin(), all.end(),
                     [&](GroupId id) { return held[id.value] && model_.groups[id].providers.size() > 1; });
}

const std::set<ProviderId>& Stakes::pushed_by(GroupId task, bool is_optional, bool optional) {
  const auto [at, fresh] = pushed_by_.try_emplace({task, is_optional, optional});
  std::set<ProviderId>& out = at->second;
  if (!fresh) return out;
  const analysis::Claims& all = claims_.of(task);
  for (const auto& [waiter, causers] : pushes_) {
    if (!all.contains(waiter)) continue;
    const bool counts =
        std::any_of(std::begin(analysis::all_reaches), std::end(analysis::all_reaches), [&](Reach reach) {
          return all.find(waiter, reach) != nullptr && (is_optional || reach == Reach::optional) == optional;
        });
    if (counts) out.insert(causers.begin(), causers.end());
  }
  return out;
}

Stake Stakes::between(const Edge& one, const Edge& other) {
  Stake out{std::vector<bool>(model_.groups.size()), {}};
  for (const auto& [place, level] : takes_.places(one)) {
    for (const auto& [others, other_level] : takes_.places(other)) {
      const bool at_once = std::get<0>(place) == std::get<0>(others) && std::get<1>(place) == std::get<1>(others);
      const Level &a = one.levels[level], &b = other.levels[other_level];
      if (!at_once || a.priority != b.priority) continue;
      add(one, a, other, b, out);
      if (!one.requester || a.optional || b.optional || a.apart == b.apart) continue;
      add_led(a.apart ? other : one, a.apart ? b : a, place, a.apart ? one : other, out);
    }
  }
  return out;
}

void Stakes::add(const Edge& one, const Level& a, const Edge& other, const Level& b, Stake& out) {
  const analysis::Claims &first = claims_.of(one.target), &second = claims_.of(other.target);
  bool may_push = false;
  for (const bool optional : {false, true}) {
    const std::set<ProviderId>&ours = pushed_by(one.target, a.optional, optional),
          &theirs = pushed_by(other.target, b.optional, optional);
    may_push = may_push || !ours.empty() || !theirs.empty();
    for (const ProviderId mine : ours) {
      for (const ProviderId their : theirs) {
        if (mine != their && model_.providers[mine].group == model_.providers[their].group)
          out.pushed.insert(name_of(model_, model_.providers[mine].group));
      }
    }
  }
  const bool is_unit = one.requester && a.shares_unit() && b.shares_unit();
  const bool choose = is_unit && (has_choice(one.target) || has_choice(other.target));
  for (const GroupId group : first.groups()) {
    if (!second.contains(group)) continue;
    for (const Reach mine : analysis::all_reaches) {
      const analysis::Claim* const claim = first.find(group, mine);
      if (claim == nullptr) continue;
      for (const Reach their : analysis::all_reaches) {
        const analysis::Claim* const rival = second.find(group, their);
        if (rival == nullptr) continue;
        const bool is_equal = (a.optional || mine == Reach::optional) == (b.optional || their == Reach::optional);
        // What is granted with the unit is its own; if both are, the order is that in which they choose.
        if (!is_equal || (is_unit && (mine == Reach::own || their == Reach::own) && (mine != their || !choose)))
          continue;
        // While their conditions exclude each other, the first one may block what the other would push.
        if (!may_push && !analysis::compatible(claim->region, rival->region)) continue;
        out.groups[group.value] = true;
      }
    }
  }
}

void Stakes::add_led(const Edge& leader, const Level& level, const Place& place, const Edge& rival, Stake& out) {
  const auto& [provider, pack, name] = place;
  std::vector<const Edge*> mates;
  for (const EdgeId id : takes_.edges().at(name_of(model_, *leader.requester))) {
    const Edge& mate = model_.edges[id];
    if (&mate == &leader || &mate == &rival) continue;
    bool is_mate = false, leads = !pack.empty(); // a named pack is requested whole
    for (const auto& [there, index] : takes_.places(mate)) {
      if (std::get<0>(there) != provider || std::get<1>(there) != pack) continue;
      const Level& each = mate.levels[index];
      is_mate = is_mate || each.shares_unit();
      leads = leads && each.shares_unit() && each.priority > level.priority;
    }
    if (is_mate && leads) return;
    if (is_mate) mates.push_back(&mate);
  }
  const analysis::Claims& theirs = claims_.of(rival.target);
  for (const Edge* mate : mates) {
    const analysis::Claims& held = claims_.of(mate->target);
    for (const GroupId group : held.groups()) {
      const bool wanted = theirs.find(group, Reach::own) != nullptr || theirs.find(group, Reach::mandatory) != nullptr;
      if (held.find(group, Reach::own) != nullptr && wanted) out.groups[group.value] = true;
    }
  }
}

} // namespace director::compiler::diff
