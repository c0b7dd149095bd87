// Header: compiler/analysis/decisions/pass.hpp. Test: tests/property/decisions_test.cpp.
// SPDX-License-Identifier: MIT
// semantics.md, 4.3: how a group can be granted: the order of its providers, their plans, and the first combination of
// the members of a unit.
#include "compiler/analysis/decisions/pass.hpp"

#include <algorithm>
#include <tuple>

namespace director::analysis {

bool Pass::holds(Row condition) const {
  const Component::ConditionRow& row = part_.conditions[condition];
  return (row.accepts & bit(last_.value[row.state])) != 0;
}

/// The push that is assumed to be in force on a group, according to the picks.
const PossiblePush* Pass::standing(Row group) {
  const std::vector<PossiblePush>& pushes = gathered_.pushes;
  int& at = standing_[group];
  if (at < 0) {
    const auto is_possible = [&](const PossiblePush& push) {
      return part_.providers[push.to].group == group && (keeping_ & bit(push.by)) != 0;
    };
    const auto count = std::count_if(pushes.begin(), pushes.end(), is_possible);
    if (count > picked_among_[group]) {
      picked_among_[group] = static_cast<int>(count);
      auto picked = picks_.pick(static_cast<std::size_t>(count) + 1);
      for (std::size_t i = 0; picked > 0; ++i) {
        if (is_possible(pushes[i]) && --picked == 0) at = static_cast<int>(i);
      }
    }
  }
  return at < 0 ? nullptr : &pushes[static_cast<std::size_t>(at)];
}

Pass::Providers Pass::preference(Row group, const Chain& edge) {
  const std::vector<Row>& providers = part_.groups[group].providers;
  Providers out;
  const PossiblePush* push = standing(group);
  if (push != nullptr && applies(push->by, edge)) out.push_back(push->to);
  const Row first = out.empty() ? nothing : push->to;
  for (const Row provider : providers) {
    if (provider != first) out.push_back(provider);
  }
  return out;
}

Pass::Chains Pass::chains_of(const Choice& choice) const {
  const Component::Plan& plan = part_.providers[choice.provider].plans[choice.plan];
  Chains out;
  for (const Component::Planned& entry : plan) {
    const Chain* above = &choice.chain;
    for (std::size_t i = 0; entry.needer != choice.group && i < out.size(); ++i) {
      if (plan[i].group == entry.needer) above = &out[i];
    }
    out.push_back(below(*above, entry.edge));
  }
  return out;
}

Pass::Plans Pass::plans_in_order(const Choice& choice) {
  const std::vector<Component::Plan>& plans = part_.providers[choice.provider].plans;
  Plans out;
  for (Row i = 0; i < plans.size(); ++i) out.push_back(i);
  if (gathered_.pushes.empty() || plans.size() < 2) return out;
  std::array<Groups, Component::most_plans> places; // of the providers of each plan among all of their groups
  for (const Row i : out) {
    Choice with = choice;
    with.plan = i;
    const Chains chains = chains_of(with);
    for (std::size_t at = 0; at < chains.size(); ++at) {
      const Providers order = preference(plans[i][at].group, chains[at]);
      places[i].push_back(
          static_cast<Row>(std::find(order.begin(), order.end(), plans[i][at].provider) - order.begin()));
    }
  }
  std::sort(out.begin(), out.end(), [&](Row a, Row b) { return std::tie(places[a], a) < std::tie(places[b], b); });
  return out;
}

/// The conditions of a provider that do not hold, if nothing is waived.
Rows Pass::lacking(Row provider) {
  const Component::ProviderRow& row = part_.providers[provider];
  const bool active = last_.has(row.group, Moment::granted) && last_.active[row.group] == provider;
  const auto hold = [&](Row condition) { return holds(condition); };
  if (active && !row.stay.empty() && std::all_of(row.stay.begin(), row.stay.end(), hold)) return 0;
  if (row.unsure) {
    if ((picked_unsure_ & bit(provider)) == 0 && picks_.any()) taken_to_hold_ |= bit(provider);
    picked_unsure_ |= bit(provider);
    if ((taken_to_hold_ & bit(provider)) != 0) return 0;
  }
  Rows out = 0;
  for (const Row condition : row.when) {
    if (!holds(condition)) out |= bit(condition); // also if it is unsure: one of those does not hold
  }
  return out;
}

Rows Pass::lacking(Row provider, const Chain& edge) {
  const Rows all = lacking(provider);
  const Component::ProviderRow& row = part_.providers[provider];
  if (all == 0 || row.causes_states == 0) return all;
  if (!last_.has(row.group, Moment::in_force) || last_.active[row.group] != provider) return all;
  const PossiblePush* push = standing(row.group);
  if (push == nullptr || push->to != provider || !applies(push->by, edge)) return all;
  Rows out = 0;
  for (const Row condition : each(all)) {
    if ((row.causes_states & bit(part_.conditions[condition].state)) == 0) out |= bit(condition);
  }
  return out;
}

void Pass::note_taken(Row group, Reasons& reasons) const {
  reasons.taken |= bit(group);
  const Row holder = holder_of(group);
  if (holder != nothing && !is_limbo(holder)) reasons.holders |= bit(holder);
}

void Pass::add_choices(Row edge, bool with_conditions) {
  Choice choice{};
  choice.chain = claimed(edge);
  choice.group = part_.edges[edge].target;
  if (!available(choice.group, choice.chain)) return note_taken(choice.group, blame_);
  const Row from = requester(edge);
  const bool as_it_is = from != nothing && stale(from);
  for (const Row provider : preference(choice.group, choice.chain)) {
    choice.provider = provider;
    ++gathered_.steps;
    if (as_it_is && last_.active[choice.group] != provider) continue;
    const Rows own = lacking(provider, choice.chain);
    Reasons why;
    if (with_conditions && own != 0) {
      why.lacking = own;
      note(provider, why);
      continue;
    }
    for (const Row plan : plans_in_order(choice)) {
      const Component::Plan& entries = part_.providers[provider].plans[plan];
      choice.plan = plan;
      gathered_.steps += static_cast<std::int64_t>(entries.size());
      if (as_it_is && last_.plan[choice.group] != plan) continue;
      choice.claims = bit(choice.group);
      choice.lacking = own;
      const Chains chains = chains_of(choice);
      bool fits = true;
      for (std::size_t i = 0; i < entries.size() && fits; ++i) {
        fits = available(entries[i].group, chains[i]);
        if (!fits) note_taken(entries[i].group, why);
        choice.claims |= bit(entries[i].group);
      }
      for (std::size_t i = 0; i < entries.size() && fits; ++i)
        choice.lacking |= lacking(entries[i].provider, chains[i]);
      why.lacking |= choice.lacking;
      if (fits && (!with_conditions || choice.lacking == 0)) choices_.push_back(choice);
    }
    if (with_conditions) note(provider, why);
  }
}

void Pass::note(Row provider, const Reasons& why) {
  gathered_.passed_over[provider].add(why);
  blame_.add(why);
}

std::optional<Pass::Combination> Pass::first_combination(const Unit& members, bool with_conditions) {
  blame_ = {};
  const auto fail = [&](Rows together) {
    blame_.together = together;
    for (const Row member : members) {
      if (!with_conditions) continue;
      Reasons& why = gathered_.refused[member];
      why.add(blame_);
      why.together &= ~bit(member);
    }
    return std::nullopt;
  };
  choices_.clear();
  Few<std::size_t, Component::most_groups + 1> begins{0}; // of the choices of each member, and where the last ones end
  for (const Row member : members) {
    blame_ = {};
    add_choices(member, with_conditions);
    if (choices_.size() == begins.back()) return fail(bit(member));
    begins.push_back(choices_.size());
  }
  auto at = begins;
  std::array<Rows, Component::most_groups + 1> claimed_so_far{};
  std::size_t depth = 0;
  while (depth < members.size()) {
    std::size_t& here = at[depth];
    for (; here < begins[depth + 1]; ++here) {
      ++gathered_.steps;
      const Rows both = choices_[here].claims & claimed_so_far[depth];
      if (both == 0) break;
      gathered_.passed_over[choices_[here].provider].taken |= both;
      blame_.taken |= both;
    }
    if (here == begins[depth + 1]) {
      if (depth == 0) {
        Rows unit = 0;
        for (const Row member : members) unit |= bit(member);
        return fail(unit);
      }
      here = begins[depth];
      ++at[--depth];
      continue;
    }
    claimed_so_far[depth + 1] = claimed_so_far[depth] | choices_[here].claims;
    ++depth;
  }
  Combination out;
  for (std::size_t i = 0; i < members.size(); ++i) out.push_back(choices_[at[i]]);
  return out;
}

} // namespace director::analysis
