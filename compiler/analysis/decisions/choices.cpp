// Header: compiler/analysis/decisions/pass.hpp. Test: tests/property/decisions_test.cpp.
// SPDX-License-Identifier: MIT
// semantics.md, 4.3: how a group can be granted: in which order its providers come, with which plans, and the first
// combination of the members of a unit.
#include "compiler/analysis/decisions/pass.hpp"

#include <algorithm>

namespace director::analysis {

bool Pass::holds(Row condition) const {
  const Component::ConditionRow& row = part_.conditions[condition];
  return (row.accepts & bit(last_.value[row.state])) != 0;
}

/// The push that stands on a group so far, if the picks say that one does.
const PossiblePush* Pass::standing(Row group) {
  int count = 0;
  std::array<int, 64> possible{};
  for (std::size_t i = 0; i < gathered_.pushes.size() && count < 64; ++i) {
    const PossiblePush& push = gathered_.pushes[i];
    if (part_.providers[push.to].group == group && (keeping_ & bit(push.by)) != 0)
      possible[static_cast<std::size_t>(count++)] = static_cast<int>(i);
  }
  int& at = standing_[group];
  if (at < 0 && count > asked_[group]) {
    asked_[group] = count;
    const auto picked = static_cast<int>(picks_.pick(static_cast<std::size_t>(count) + 1)) - 1;
    at = picked < 0 ? -1 : possible[static_cast<std::size_t>(picked)];
  }
  return at < 0 ? nullptr : &gathered_.pushes[static_cast<std::size_t>(at)];
}

std::vector<Row> Pass::preference(Row group, const Chain& edge) {
  std::vector<Row> out = part_.groups[group].providers;
  const PossiblePush* push = standing(group);
  if (push == nullptr || !applies(push->by, edge)) return out;
  std::stable_partition(out.begin(), out.end(), [&](Row provider) { return provider == push->to; });
  return out;
}

std::vector<Pass::Chain> Pass::chains_of(const Choice& choice) const {
  const Component::Plan& plan = part_.providers[choice.provider].plans[choice.plan];
  std::vector<Chain> out;
  for (const Component::Planned& entry : plan) {
    const Chain* above = &choice.chain;
    for (std::size_t i = 0; entry.needer != choice.group && i < out.size(); ++i) {
      if (plan[i].group == entry.needer) above = &out[i];
    }
    out.push_back(below(*above, entry.edge));
  }
  return out;
}

std::vector<Row> Pass::plans_in_order(const Choice& choice) {
  const std::vector<Component::Plan>& plans = part_.providers[choice.provider].plans;
  std::vector<Row> out;
  for (Row i = 0; i < plans.size(); ++i) out.push_back(i);
  if (gathered_.pushes.empty() || plans.size() < 2) return out;
  std::vector<std::pair<std::vector<std::ptrdiff_t>, Row>> keyed;
  for (const Row i : out) {
    Choice with = choice;
    with.plan = i;
    const std::vector<Chain> chains = chains_of(with);
    std::vector<std::ptrdiff_t> places;
    for (std::size_t at = 0; at < chains.size(); ++at) {
      const std::vector<Row> order = preference(plans[i][at].group, chains[at]);
      places.push_back(std::find(order.begin(), order.end(), plans[i][at].provider) - order.begin());
    }
    keyed.emplace_back(std::move(places), i);
  }
  std::stable_sort(keyed.begin(), keyed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = keyed[i].second;
  return out;
}

/// Nothing is waived.
void Pass::add_lacking(Row provider, std::vector<Row>& out) {
  const Component::ProviderRow& row = part_.providers[provider];
  const bool active = last_.has(row.group, Moment::granted) && last_.active[row.group] == provider;
  const auto hold = [&](Row condition) { return holds(condition); };
  if (active && !row.stay.empty() && std::all_of(row.stay.begin(), row.stay.end(), hold)) return;
  if (row.unsure) {
    signed char& sure = unsure_[provider];
    if (sure < 0) sure = picks_.any() ? 1 : 0;
    if (sure == 1) return;
    out.insert(out.end(), row.when.begin(), row.when.end());
    return;
  }
  for (const Row condition : row.when) {
    if (!holds(condition)) out.push_back(condition);
  }
}

void Pass::add_lacking(Row provider, const Chain& edge, std::vector<Row>& out) {
  const std::size_t begin = out.size();
  add_lacking(provider, out);
  const Component::ProviderRow& row = part_.providers[provider];
  if (out.size() == begin || row.causes_states == 0) return;
  if (!last_.has(row.group, Moment::in_force) || last_.active[row.group] != provider) return;
  const PossiblePush* push = standing(row.group);
  if (push == nullptr || push->to != provider || !applies(push->by, edge)) return;
  out.erase(
      std::remove_if(out.begin() + static_cast<std::ptrdiff_t>(begin), out.end(),
                     [&](Row condition) { return (row.causes_states & bit(part_.conditions[condition].state)) != 0; }),
      out.end());
}

void Pass::note_taken(Row group, Reasons& reasons) const {
  reasons.taken |= bit(group);
  const Row holder = holder_of(group);
  if (holder != nothing && !is_limbo(holder)) reasons.holders |= bit(holder);
}

std::vector<Pass::Choice> Pass::choices(Row edge, bool with_conditions) {
  std::vector<Choice> out;
  Choice choice;
  choice.chain = claimed(edge);
  choice.group = part_.edges[edge].target;
  if (!available(choice.group, choice.chain)) {
    note_taken(choice.group, blame_);
    return out;
  }
  const Row from = requester(edge);
  const bool as_it_is = from != nothing && stale(from);
  for (const Row provider : preference(choice.group, choice.chain)) {
    choice.provider = provider;
    ++gathered_.steps;
    if (as_it_is && last_.active[choice.group] != provider) continue;
    std::vector<Row> own;
    add_lacking(provider, choice.chain, own);
    Reasons why;
    if (with_conditions && !own.empty()) {
      for (const Row condition : own) why.lacking |= bit(condition);
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
      const std::vector<Chain> chains = chains_of(choice);
      bool fits = true;
      for (std::size_t i = 0; i < entries.size() && fits; ++i) {
        fits = available(entries[i].group, chains[i]);
        if (!fits) note_taken(entries[i].group, why);
        choice.claims |= bit(entries[i].group);
      }
      for (std::size_t i = 0; i < entries.size() && fits; ++i)
        add_lacking(entries[i].provider, chains[i], choice.lacking);
      for (const Row condition : choice.lacking) why.lacking |= bit(condition);
      if (fits && (!with_conditions || choice.lacking.empty())) out.push_back(choice);
    }
    if (with_conditions) note(provider, why);
  }
  return out;
}

void Pass::note(Row provider, const Reasons& why) {
  gathered_.passed_over[provider].add(why);
  blame_.add(why);
}

std::optional<Pass::Combination> Pass::first_combination(const std::vector<Row>& members, bool with_conditions) {
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
  std::vector<std::vector<Choice>> of_each;
  for (const Row member : members) {
    blame_ = {};
    of_each.push_back(choices(member, with_conditions));
    if (of_each.back().empty()) return fail(bit(member));
  }
  std::vector<std::size_t> at(members.size(), 0);
  std::vector<Rows> claimed_so_far(members.size() + 1, 0);
  std::size_t depth = 0;
  while (depth < members.size()) {
    const std::vector<Choice>& all = of_each[depth];
    for (; at[depth] < all.size(); ++at[depth]) {
      ++gathered_.steps;
      const Rows both = all[at[depth]].claims & claimed_so_far[depth];
      if (both == 0) break;
      gathered_.passed_over[all[at[depth]].provider].taken |= both;
      blame_.taken |= both;
    }
    if (at[depth] == all.size()) {
      if (depth == 0) {
        Rows unit = 0;
        for (const Row member : members) unit |= bit(member);
        return fail(unit);
      }
      at[depth] = 0;
      ++at[--depth];
      continue;
    }
    claimed_so_far[depth + 1] = claimed_so_far[depth] | all[at[depth]].claims;
    ++depth;
  }
  Combination out;
  for (std::size_t i = 0; i < members.size(); ++i) out.push_back(std::move(of_each[i][at[i]]));
  return out;
}

} // namespace director::analysis
