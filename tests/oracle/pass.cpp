// Header: tests/oracle/pass.hpp. Test: tests/oracle/conformance_test.cpp.
// SPDX-License-Identifier: MIT
// semantics.md, 4.4: the pass.
#include "tests/oracle/pass.hpp"

#include <algorithm>

namespace director::oracle {

Assignment arbitrate(const Parts& parts, const Facts& facts, const Assignment& last, Notes& notes) {
  for (std::set<EdgeId> forgotten;; ++notes.repetitions) {
    notes.most_repetitions = std::max(notes.most_repetitions, static_cast<int>(forgotten.size()));
    Pass pass(parts, facts, last, forgotten, notes);
    pass.take_candidates();
    if (const std::optional<EdgeId> f = pass.wrongly_denied()) {
      forgotten.insert(*f);
      continue;
    }
    pass.hand_over();
    return pass.finish();
  }
}

Pass::Pass(const Parts& parts, const Facts& facts, const Assignment& last, const std::set<EdgeId>& forgotten,
           Notes& notes)
    : parts_(parts),
      facts_(facts),
      last_(last),
      forgotten_(forgotten),
      notes_(notes),
      order_(parts, facts),
      now_(parts.model()) {
  notes_.claimed_before.clear();
  for (const auto& task : parts.model().roots) {
    if (facts.request[task.edge]) candidates_.insert(task.edge);
  }
}

void Pass::take_candidates() {
  for (;;) {
    std::erase_if(candidates_, [&](EdgeId edge) { return !may_ask(parts_.requester(edge)); });
    if (candidates_.empty()) return;
    const EdgeId first = *std::min_element(candidates_.begin(), candidates_.end(), [&](EdgeId a, EdgeId b) {
      return a != b && order_.first(claimed_chain(a), claimed_chain(b));
    });
    const std::vector<EdgeId> unit = unit_of(first);
    for (const EdgeId member : unit) candidates_.erase(member), tried_.insert(member);
    const std::optional<GroupId> requester = parts_.requester(first);
    if (requester && stale(*requester)) {
      for (const EdgeId member : unit) take_below_stale(member);
    } else {
      take(unit);
    }
  }
}

std::vector<EdgeId> Pass::unit_of(EdgeId first) const {
  const auto alone = [&](EdgeId edge) {
    const Level& level = parts_.model().edges[edge].levels.at(facts_.request[edge]->level);
    return !parts_.requester(edge) || level.optional || level.apart;
  };
  if (alone(first)) return {first};
  std::vector<EdgeId> unit;
  for (const EdgeId edge : candidates_) {
    if (!alone(edge) && parts_.requester(edge) == parts_.requester(first)) unit.push_back(edge);
  }
  std::sort(unit.begin(), unit.end(),
            [&](EdgeId a, EdgeId b) { return a != b && order_.first(claimed_chain(a), claimed_chain(b)); });
  return unit;
}

// Stale. A group that is held only as a need is stale if the group that needs it is.
bool Pass::stale(GroupId group) const {
  const std::optional<Held>& held = now_.held[group];
  if (!held) return false;
  if (parts_.is_limbo(held->by)) return true;
  if (!held->granted) return parts_.requester(held->by) && stale(*parts_.requester(held->by));
  const std::set<Reason>& pending = facts_.pending[group];
  return pending.contains(Reason::new_task) || pending.contains(Reason::pushed) || facts_.anew.contains(held->by) ||
         !last_.held_by(held->by, group) || last_.active[group] != now_.active[group];
}

// For a stale group nothing new is acquired, and nothing is dropped.
void Pass::take_below_stale(EdgeId member) {
  if (!granted_before(member)) {
    refused_.insert(member);
    keep_pushes({member});
    return;
  }
  if (grant_alone(member)) return;
  refused_.insert(member);
  if (first_combination({member}, false)) keep_pushes({member}); // otherwise it is blocked
}

// The pack of a group that is held only as a need counts only while it is stale.
bool Pass::may_ask(const std::optional<GroupId>& requester) const {
  return !requester || now_.granted(*requester) || stale(*requester);
}

void Pass::take(const std::vector<EdgeId>& unit) {
  const std::optional<Combination> combination = first_combination(unit, true);
  if (!combination) {
    refuse(unit);
  } else if (!deferred(*combination)) {
    grant(*combination);
  } else {
    ++notes_.deferrals;
    for (const EdgeId member : unit) {
      if (!granted_before(member) || !grant_alone(member)) {
        refused_.insert(member);
        keep_pushes({member});
      }
    }
  }
}

bool Pass::grant_alone(EdgeId member) {
  const std::optional<Combination> found = first_combination({member}, true);
  if (found) grant(*found);
  return found.has_value();
}

void Pass::grant(const Combination& combination) {
  for (const Choice& choice : combination) {
    if (choice.plan != parts_.plans(choice.provider).front()) ++notes_.later_plans;
    claim(choice, true);
  }
  keep_serving_pushes(combination);
}

namespace {

/// The part of a plan that a group in it needs.
Plan plan_below(const Plan& plan, GroupId group) {
  std::set<GroupId> inside{group};
  Plan out;
  for (const PlanEntry& entry : plan) {
    if (!inside.contains(entry.needer)) continue;
    inside.insert(entry.group);
    out.push_back(entry);
  }
  return out;
}

} // namespace

// A granted group controls its whole plan.
void Pass::claim(const Choice& choice, bool granted) {
  std::optional<Held>& target = now_.held[choice.group];
  target = Held{choice.edge(), granted, target && target->needed, false};
  now_.active[choice.group] = choice.provider;
  now_.plan[choice.group] = choice.plan;
  follow(choice.group);
  for (const PlanEntry& entry : choice.plan) {
    std::optional<Held>& held = now_.held[entry.group];
    if (!held) held = Held{entry.by, false, false, false};
    held->needed = true;
    if (!held->granted) now_.plan[entry.group] = plan_below(choice.plan, entry.group);
  }
  for (const PlanEntry& entry : choice.plan) {
    if (last_.active[entry.group] && stale(entry.group)) follow(entry.group);
  }
}

// The pack edges of a group that is claimed become candidates.
void Pass::follow(GroupId requester) {
  for (const EdgeId edge : parts_.model().groups[requester].edges) {
    if (facts_.request[edge] && !tried_.contains(edge)) candidates_.insert(edge);
  }
}

// Defer: nothing starts that a decision above it is about to stop.
bool Pass::deferred(const Combination& combination) const {
  for (const Choice& choice : combination) {
    if (granted_before(choice.edge())) continue;
    std::vector<GroupId> claims{choice.group};
    for (const PlanEntry& entry : choice.plan) claims.push_back(entry.group);
    for (const GroupId other : parts_.model().groups.ids()) {
      if (!now_.granted(other) || !stale(other)) continue;
      const Chain holder = claimed_chain(now_.held[other]->by);
      if (!order_.before(holder, choice.chain) || choice.chain.below(holder.edge())) continue;
      if (std::any_of(claims.begin(), claims.end(), [&](GroupId g) { return parts_.may_ask_for(other, g); }))
        return true;
    }
  }
  return false;
}

void Pass::keep_pushes(const std::vector<EdgeId>& unit) {
  for (const auto& [group, push] : last_.pushes) {
    if (std::find(unit.begin(), unit.end(), push.by) != unit.end()) now_.pushes.emplace(group, push);
  }
}

// Grant: the unit's pushes stay as far as they serve.
void Pass::keep_serving_pushes(const Combination& combination) {
  std::set<ConditionId> wanted;
  const auto want = [&](ProviderId provider) {
    const compiler::Provider& words = parts_.model().providers[provider];
    for (const auto& use : words.when) wanted.insert(use.id);
    for (const auto& use : words.stay) wanted.insert(use.id);
  };
  std::vector<EdgeId> unit;
  for (const Choice& choice : combination) {
    unit.push_back(choice.edge());
    want(choice.provider);
    for (const PlanEntry& entry : choice.plan) want(entry.provider);
  }
  std::map<GroupId, Push> serving;
  for (bool more = true; more;) {
    more = false;
    for (const auto& [group, push] : last_.pushes) {
      if (std::find(unit.begin(), unit.end(), push.by) == unit.end() || serving.contains(group)) continue;
      const ProviderId to = push.to;
      if (std::none_of(wanted.begin(), wanted.end(), [&](ConditionId c) { return parts_.causes(to, c); })) continue;
      serving.emplace(group, push);
      more = true;
      want(to);
      for (const Plan& plan : parts_.plans(to)) {
        for (const PlanEntry& entry : plan) want(entry.provider);
      }
    }
  }
  now_.pushes.insert(serving.begin(), serving.end());
}

// Limbo: it goes after everything, keeps no group from any edge, and runs nothing.
void Pass::hand_over() {
  for (const GroupId group : last_.order) {
    if (!last_.active[group] || now_.held[group]) continue;
    bool heir = false;
    for (const GroupId other : parts_.model().groups.ids())
      heir = heir || (now_.granted(other) && stale(other) && parts_.may_ask_for(other, group));
    const Plan& plan = last_.plan[group];
    const auto free = [&](const PlanEntry& entry) { return !now_.held[entry.group]; };
    if (!heir || !std::all_of(plan.begin(), plan.end(), free)) continue;
    ++notes_.limbo;
    claim({claimed_chain(parts_.limbo(group)), group, *last_.active[group], plan, {}}, false);
    take_candidates();
  }
}

Assignment Pass::finish() {
  for (const GroupId group : parts_.model().groups.ids()) {
    if (!now_.held[group]) continue;
    now_.held[group]->stale = stale(group);
    // A group that is held only as a need is live while it is stale.
    if (!now_.active[group] && stale(group)) now_.active[group] = last_.active[group];
    now_.order.push_back(group);
  }
  std::sort(now_.order.begin(), now_.order.end(), [&](GroupId a, GroupId b) {
    return a != b && order_.first(claimed_chain(now_.held[a]->by), claimed_chain(now_.held[b]->by));
  });
  finish_pushes();
  return std::move(now_);
}

void Pass::finish_pushes() {
  std::erase_if(now_.pushes, [&](const auto& pair) {
    if (now_.held[pair.first]) return false;
    const std::vector<EdgeId>& edges = parts_.model().groups[pair.first].requesters;
    return std::none_of(edges.begin(), edges.end(), [&](EdgeId edge) {
      const std::optional<GroupId> requester = parts_.requester(edge);
      return facts_.request[edge] && (!requester || now_.active[*requester]);
    });
  });
  // 4.3: the pushes in force.
  for (const auto& [group, push] : now_.pushes) {
    if (!now_.held[group] || now_.active[group] != push.to) continue;
    if (!applies(push, claimed_chain(now_.held[group]->by))) continue;
    if (!now_.held[group]->granted && !last_.in_force.contains(group)) continue;
    now_.in_force.insert(group);
    if (!facts_.holds(parts_.model(), push.unmet)) now_.serving.emplace(group, Service{push.to, push.unmet});
  }
}

} // namespace director::oracle
