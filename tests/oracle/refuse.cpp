// Header: tests/oracle/pass.hpp. Test: tests/oracle/conformance_test.cpp.
// SPDX-License-Identifier: MIT
// semantics.md, 4.4: a unit that is refused, and the pushes that it makes.
#include "tests/oracle/pass.hpp"

#include <algorithm>

namespace director::oracle {

namespace {

bool contains(const std::vector<EdgeId>& unit, EdgeId edge) {
  return std::find(unit.begin(), unit.end(), edge) != unit.end();
}

} // namespace

void Pass::refuse(const std::vector<EdgeId>& unit) {
  refused_.insert(unit.begin(), unit.end());
  IdTable<GroupId, std::optional<EdgeId>> claims(parts_.model().groups.size());
  for (const GroupId group : parts_.model().groups.ids()) {
    if (now_.held[group]) claims[group] = now_.held[group]->by;
  }
  for (const EdgeId edge : unit) notes_.claimed_before.insert_or_assign(edge, claims);
  const std::optional<Combination> combination = first_combination(unit, false);
  if (!combination) return; // blocked: it loses its pushes
  if (deferred(*combination)) {
    ++notes_.deferrals;
    keep_pushes(unit);
    return;
  }
  const std::vector<Unmet> missing = unmet(*combination);
  const auto hopeless = [&](const Unmet& one) { return !can_be_caused(one.condition); };
  if (std::any_of(missing.begin(), missing.end(), hopeless)) return; // no provider can cause it
  keep_pushes(unit);
  push(unit, missing);
}

std::vector<Pass::Unmet> Pass::unmet(const Combination& combination) const {
  std::vector<Unmet> out;
  for (const Choice& choice : combination) {
    for (const ConditionId condition : choice.lacking) out.push_back({choice.chain, condition});
  }
  return out;
}

bool Pass::can_be_caused(ConditionId condition) const {
  for (const ProviderId p : parts_.model().providers.ids()) {
    if (facts_.enabled(p) && parts_.causes(p, condition)) return true;
  }
  return false;
}

// Whether its group is requested by an edge that the member goes before, not claimed, and not pushed elsewhere by
// another unit.
bool Pass::can_be_pushed(ProviderId provider, const Chain& member, const std::vector<EdgeId>& unit) const {
  const GroupId group = parts_.group_of(provider);
  if (!facts_.enabled(provider) || now_.held[group]) return false;
  const auto push = now_.pushes.find(group);
  if (push != now_.pushes.end() && push->second.to != provider && !contains(unit, push->second.by)) return false;
  const std::vector<EdgeId>& edges = parts_.model().groups[group].requesters;
  return std::any_of(edges.begin(), edges.end(), [&](EdgeId edge) {
    // No edge goes before itself, though its current chain may go before its last one.
    if (!facts_.request[edge] || edge == member.edge()) return false;
    const Chain asking = previous_chain(edge);
    return asking.complete && order_.before(member, asking) && !asking.below(member.edge());
  });
}

bool Pass::plan_is_free(const Plan& plan) const {
  return std::all_of(plan.begin(), plan.end(),
                     [&](const PlanEntry& entry) { return facts_.enabled(entry.provider) && !now_.held[entry.group]; });
}

// The shortest way to make a condition true, with the known ways for others; then the earliest declaration.
std::optional<Pass::Way> Pass::way(ConditionId condition, const Chain& member, const std::vector<EdgeId>& unit,
                                   const Ways& known) const {
  std::optional<Way> best;
  for (const ProviderId provider : parts_.model().providers.ids()) {
    if (!parts_.causes(provider, condition) || !can_be_pushed(provider, member, unit)) continue;
    for (const Plan& plan : parts_.plans(provider)) {
      if (!plan_is_free(plan)) continue;
      std::vector<ConditionId> missing = lacking(provider);
      for (const PlanEntry& entry : plan) {
        for (const ConditionId c : lacking(entry.provider)) missing.push_back(c);
      }
      if (!std::all_of(missing.begin(), missing.end(), [&](ConditionId c) { return known.contains(c); })) continue;
      Way found{provider, std::nullopt, 1};
      if (!missing.empty()) found.lacking = missing.front();
      for (const ConditionId c : missing) found.length += known.at(c).length;
      if (!best || found.length < best->length) best = found;
    }
  }
  return best;
}

// A least fixed point: lengths only decrease.
Pass::Ways Pass::search(const Chain& member, const std::vector<EdgeId>& unit) const {
  Ways known;
  for (bool more = true; more;) {
    more = false;
    for (const ConditionId condition : parts_.model().conditions.ids()) {
      const std::optional<Way> found = way(condition, member, unit, known);
      if (!found || (known.contains(condition) && known.at(condition).length <= found->length)) continue;
      known[condition] = *found;
      more = true;
    }
  }
  for (auto& [condition, chosen] : known) chosen = *way(condition, member, unit, known);
  return known;
}

void Pass::push(const std::vector<EdgeId>& unit, const std::vector<Unmet>& unmet) {
  const auto ours = [&](const Push& push) { return contains(unit, push.by); };
  const auto kept_for = [&](ConditionId condition) {
    return std::any_of(last_.pushes.begin(), last_.pushes.end(), [&](const auto& pair) {
      return ours(pair.second) && now_.pushes.at(pair.first).to == pair.second.to &&
             parts_.causes(pair.second.to, condition);
    });
  };
  std::map<GroupId, Push> made;
  bool ladder = false;
  for (const Unmet& one : unmet) {
    if (kept_for(one.condition)) continue;
    const Ways ways = search(one.member, unit);
    const auto found = ways.find(one.condition);
    if (found == ways.end()) return; // not served: no new push is made
    ladder = ladder || found->second.length > 1;
    ConditionId aim = one.condition;
    while (ways.at(aim).lacking) aim = *ways.at(aim).lacking;
    const Push push{one.member.edge(), ways.at(aim).causing, aim};
    const GroupId group = parts_.group_of(push.to);
    const auto standing = now_.pushes.find(group);
    if (made.contains(group)) continue; // not changed: the one just made serves another unmet condition
    if (standing != now_.pushes.end()) {
      const ProviderId to = standing->second.to;
      const bool serves_another = std::any_of(unmet.begin(), unmet.end(),
                                              [&](const Unmet& other) { return parts_.causes(to, other.condition); });
      if (!ours(standing->second) || serves_another) continue;
      // The same push again is no new one, but serves this condition.
      if (to == push.to) made.emplace(group, standing->second);
    }
    made.emplace(group, push);
  }
  for (const auto& [group, push] : made) now_.pushes.insert_or_assign(group, push);
  if (ladder && !made.empty()) ++notes_.ladders;
}

} // namespace director::oracle
