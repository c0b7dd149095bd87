// Header: compiler/transitions/changes.hpp. Test: tests/compiler/transitions/matrix_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/transitions/changes.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <utility>

namespace director::compiler::transitions {

namespace {

/// Limit for states of which every choice is tried; with more, all or none.
constexpr std::size_t most_changes = 4;

/// Limit for choices of values with which preferred providers would not run.
constexpr std::size_t most_preventions = 32;

/// What the column needs from outside and does not have, each with the first suitable value.
Values lacking(const Beginning& row, const Beginning& column) {
  Values out;
  for (const auto& [id, wanted] : column.outside.wanted) {
    const auto now = row.rest.values.find(id);
    if (now == row.rest.values.end() || !wanted.contains(now->second)) out.emplace(id, wanted.intervals().front().low);
  }
  return out;
}

ValueSet wanted_of(const Model& model, const Beginning& column, StateId id) {
  const auto wanted = column.outside.wanted.find(id);
  return wanted == column.outside.wanted.end() ? model.states[id].domain() : wanted->second;
}

/// Whether some value from outside that suits the column keeps the provider from running.
bool is_preventable(const Model& model, const Beginning& column, ProviderId id) {
  const std::vector<ConditionUse>& when = model.providers[id].when;
  return std::any_of(when.begin(), when.end(), [&](const ConditionUse& use) {
    const Condition& condition = model.conditions[use.id];
    return model.states[condition.state].external &&
           !wanted_of(model, column, condition.state).without(condition.accepts).empty();
  });
}

/// Narrows `left`, the values of the states that have to change, of which the first ones are in `now`, until none of
/// these providers would run. A value that prevents one may let another one run: so all are asked again.
bool prevent(const Model& model, const std::vector<ProviderId>& preferred, const Beginning& column, Values& now,
             std::map<StateId, ValueSet>& left, std::size_t& tries) {
  const auto accepts = [&](const ConditionUse& use) {
    const Condition& condition = model.conditions[use.id];
    const auto value = now.find(condition.state);
    return value != now.end() && condition.accepts.contains(value->second);
  };
  const auto first = std::find_if(preferred.begin(), preferred.end(), [&](ProviderId id) {
    const std::vector<ConditionUse>& when = model.providers[id].when;
    return std::all_of(when.begin(), when.end(), accepts);
  });
  if (first == preferred.end()) return true;
  if (++tries > most_preventions) return false;
  for (const ConditionUse& use : model.providers[*first].when) {
    const Condition& condition = model.conditions[use.id];
    if (!model.states[condition.state].external) continue;
    const Values now_before = now;
    const std::map<StateId, ValueSet> left_before = left;
    ValueSet& set = left.try_emplace(condition.state, wanted_of(model, column, condition.state)).first->second;
    set = set.without(condition.accepts);
    if (!set.empty()) {
      now.insert_or_assign(condition.state, set.intervals().front().low);
      if (prevent(model, preferred, column, now, left, tries)) return true;
    }
    now = now_before;
    left = left_before;
  }
  return false;
}

/// What else has to change if, with these values, providers would run that are preferred to the column's requester's
/// ones: the row may have let them run.
Values in_the_way(const Model& model, const Beginning& row, const Beginning& column, const Values& change) {
  std::vector<ProviderId> preferred;
  for (const Link& link : column.way.links) {
    for (const ProviderId id : model.group_of(link.provider).providers) {
      if (id == link.provider) break;
      if (is_preventable(model, column, id)) preferred.push_back(id);
    }
  }
  Values now = row.rest.values;
  for (const auto& [id, value] : change) now.insert_or_assign(id, value);
  std::map<StateId, ValueSet> left;
  std::size_t tries = 0;
  Values out;
  if (!prevent(model, preferred, column, now, left, tries)) return out;
  for (const auto& [id, set] : left) out.emplace(id, set.intervals().front().low);
  return out;
}

/// Every choice of these, the fewest first.
std::vector<Values> choices(const Values& all) {
  if (all.size() > most_changes) return {{}, all};
  const std::vector<std::pair<StateId, std::int64_t>> list(all.begin(), all.end());
  std::vector<unsigned> masks;
  for (unsigned mask = 0; mask < 1u << list.size(); ++mask) masks.push_back(mask);
  std::stable_sort(masks.begin(), masks.end(),
                   [](unsigned a, unsigned b) { return std::popcount(a) < std::popcount(b); });
  std::vector<Values> out;
  for (const unsigned mask : masks) {
    Values some;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if ((mask >> i & 1) != 0) some.insert(list[i]);
    }
    out.push_back(std::move(some));
  }
  return out;
}

} // namespace

Changes changes_for(const Model& model, const Beginning& row, const Beginning& column) {
  Changes out{choices(lacking(row, column)), 0};
  out.usual = out.all.size();
  for (std::size_t i = 0; i < out.usual; ++i) {
    Values more = in_the_way(model, row, column, out.all[i]);
    if (more.empty()) continue;
    for (const auto& each : out.all[i]) more.insert(each);
    if (std::find(out.all.begin(), out.all.end(), more) == out.all.end()) out.all.push_back(std::move(more));
  }
  return out;
}

} // namespace director::compiler::transitions
