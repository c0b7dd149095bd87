// Header: tests/oracle/pass.hpp. Test: tests/oracle/conformance_test.cpp.
// SPDX-License-Identifier: MIT
// semantics.md, 4.3: how a group can be granted to an edge.
#include "tests/oracle/pass.hpp"

#include <algorithm>

namespace director::oracle {

// The pusher goes before the edge, and the edge is not below it.
bool Pass::applies(const Push& push, const Chain& edge) const {
  return order_.before(claimed_chain(push.by), edge) && !edge.below(push.by);
}

std::vector<ProviderId> Pass::preference(GroupId group, const Chain& edge) const {
  std::vector<ProviderId> providers = parts_.model().groups[group].providers;
  const auto push = now_.pushes.find(group);
  if (push == now_.pushes.end()) return providers;
  if (!applies(push->second, edge)) return providers;
  std::stable_partition(providers.begin(), providers.end(), [&](ProviderId p) { return p == push->second.to; });
  return providers;
}

std::vector<Plan> Pass::plans_in_order(const Choice& choice) const {
  std::vector<Plan> plans = parts_.plans(choice.provider);
  if (now_.pushes.empty()) return plans;
  // A push orders the choices within plans as well: compare the places in the order of preference, depth first.
  using Places = std::vector<std::ptrdiff_t>;
  std::vector<std::pair<Places, Plan>> keyed;
  for (const Plan& plan : plans) {
    Places places;
    for (const auto& [entry, chain] : chains_of({choice.chain, choice.group, choice.provider, plan, {}})) {
      const std::vector<ProviderId> order = preference(entry.group, chain);
      places.push_back(std::find(order.begin(), order.end(), entry.provider) - order.begin());
    }
    keyed.emplace_back(places, plan);
  }
  std::stable_sort(keyed.begin(), keyed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::transform(keyed.begin(), keyed.end(), plans.begin(), [](const auto& pair) { return pair.second; });
  return plans;
}

// All choices for an edge whose groups are available; with_conditions: and whose conditions hold.
std::vector<Choice> Pass::choices(EdgeId edge, bool with_conditions) {
  Choice choice{claimed_chain(edge), parts_.target(edge), {}, {}, {}};
  std::vector<Choice> out;
  if (!available(choice.group, choice.chain)) return out;
  const std::optional<GroupId> requester = parts_.requester(edge);
  const bool as_it_is = requester && stale(*requester); // 4.4, Stale: no other provider or plan
  for (const ProviderId provider : preference(choice.group, choice.chain)) {
    choice.provider = provider;
    if (as_it_is && last_.active[choice.group] != provider) continue;
    if (!facts_.enabled(provider) || (with_conditions && !lacking(provider, choice.chain).empty())) continue;
    for (const Plan& plan : plans_in_order(choice)) {
      choice.plan = plan;
      if (as_it_is && last_.plan[choice.group] != plan) continue;
      if (!plan_available(choice)) continue;
      choice.lacking = lacking(provider, choice.chain);
      for (const auto& [entry, chain] : chains_of(choice)) {
        for (const ConditionId condition : lacking(entry.provider, chain)) choice.lacking.push_back(condition);
      }
      if (!with_conditions || choice.lacking.empty()) out.push_back(choice);
    }
  }
  return out;
}

std::vector<std::pair<PlanEntry, Chain>> Pass::chains_of(const Choice& choice) {
  std::map<GroupId, Chain> chains{{choice.group, choice.chain}};
  std::vector<std::pair<PlanEntry, Chain>> out;
  for (const PlanEntry& entry : choice.plan) {
    const Chain chain = below(chains.at(entry.needer), entry.by);
    chains.emplace(entry.group, chain);
    out.emplace_back(entry, chain);
  }
  return out;
}

bool Pass::plan_available(const Choice& choice) {
  for (const auto& [entry, chain] : chains_of(choice)) {
    if (!facts_.enabled(entry.provider) || !available(entry.group, chain)) return false;
  }
  return true;
}

// Whether a push in force waives the condition: it is on a state that the provider causes itself.
bool Pass::waived(ProviderId provider, ConditionId condition, const Chain& edge) const {
  const GroupId group = parts_.group_of(provider);
  const auto push = now_.pushes.find(group);
  return last_.in_force.contains(group) && last_.active[group] == provider && push != now_.pushes.end() &&
         push->second.to == provider && applies(push->second, edge) &&
         parts_.causes_state(provider, parts_.model().conditions[condition].state);
}

std::vector<ConditionId> Pass::lacking(ProviderId provider) const {
  const compiler::Provider& words = parts_.model().providers[provider];
  const auto missing = [&](const std::vector<compiler::ConditionUse>& uses) {
    std::vector<ConditionId> out;
    for (const auto& use : uses) {
      if (!facts_.holds(parts_.model(), use.id)) out.push_back(use.id);
    }
    return out;
  };
  const bool active = last_.granted(words.group) && last_.active[words.group] == provider;
  if (active && !words.stay.empty() && missing(words.stay).empty()) return {};
  return missing(words.when);
}

std::vector<ConditionId> Pass::lacking(ProviderId provider, const Chain& edge) const {
  std::vector<ConditionId> out = lacking(provider);
  std::erase_if(out, [&](ConditionId condition) { return waived(provider, condition, edge); });
  return out;
}

namespace {

bool shares_a_group(const Choice& a, const Choice& b) {
  const auto takes = [](const Choice& choice, GroupId group) {
    return choice.group == group || std::any_of(choice.plan.begin(), choice.plan.end(),
                                                [&](const PlanEntry& entry) { return entry.group == group; });
  };
  return takes(b, a.group) ||
         std::any_of(a.plan.begin(), a.plan.end(), [&](const PlanEntry& entry) { return takes(b, entry.group); });
}

bool combine(const std::vector<std::vector<Choice>>& of_each, Combination& so_far) {
  if (so_far.size() == of_each.size()) return true;
  for (const Choice& choice : of_each[so_far.size()]) {
    const auto clashes = [&](const Choice& other) { return shares_a_group(choice, other); };
    if (std::any_of(so_far.begin(), so_far.end(), clashes)) continue;
    so_far.push_back(choice);
    if (combine(of_each, so_far)) return true;
    so_far.pop_back();
  }
  return false;
}

} // namespace

// The first combination in lexicographic order of the members in which all claims are compatible.
std::optional<Combination> Pass::first_combination(const std::vector<EdgeId>& members, bool with_conditions) {
  std::vector<std::vector<Choice>> of_each;
  for (const EdgeId member : members) {
    of_each.push_back(choices(member, with_conditions));
    if (of_each.back().empty()) return std::nullopt;
  }
  Combination found;
  if (!combine(of_each, found)) return std::nullopt;
  return found;
}

} // namespace director::oracle
