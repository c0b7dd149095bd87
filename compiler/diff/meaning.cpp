// Header: compiler/diff/meaning.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/diff/meaning.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace director::compiler::diff {

namespace {

/// The values that the conditions on each state accept together.
std::map<StateId, ValueSet> gathered(const Model& model, const std::vector<ConditionUse>& conditions,
                                     ValueSet (ValueSet::*with)(const ValueSet&) const) {
  std::map<StateId, ValueSet> out;
  for (const ConditionUse& use : conditions) {
    const Condition& condition = model.conditions[use.id];
    const auto [at, fresh] = out.try_emplace(condition.state, condition.accepts);
    if (!fresh) at->second = (at->second.*with)(condition.accepts);
  }
  return out;
}

} // namespace

Values values_of(const State& state, const ValueSet& set) {
  Values out;
  out.is_range = state.is_range;
  if (state.is_range) {
    out.range = set;
    return out;
  }
  for (std::size_t i = 0; i < state.values.size(); ++i) {
    if (set.contains(static_cast<std::int64_t>(i))) out.words.push_back(state.values[i]);
  }
  std::sort(out.words.begin(), out.words.end());
  return out;
}

Values without(const Values& first, const Values& second) {
  if (first.is_range != second.is_range) return first;
  Values out;
  out.is_range = first.is_range;
  out.range = first.range.without(second.range);
  std::set_difference(first.words.begin(), first.words.end(), second.words.begin(), second.words.end(),
                      std::back_inserter(out.words));
  return out;
}

std::string to_text(const Values& values) {
  if (!values.is_range) return fmt::format("{}", fmt::join(values.words, "|"));
  std::vector<std::string> parts;
  for (const ValueSet::Interval& each : values.range.intervals())
    parts.push_back(each.low == each.high ? fmt::format("{}", each.low) : fmt::format("{}..{}", each.low, each.high));
  return fmt::format("{}", fmt::join(parts, "|"));
}

std::map<std::string, Values> all_of(const Model& model, const std::vector<ConditionUse>& conditions) {
  std::map<std::string, Values> out;
  for (const auto& [id, set] : gathered(model, conditions, &ValueSet::intersected)) {
    const State& state = model.states[id];
    if (state.may_be_unset() || set != state.domain()) out.emplace(state.name.value, values_of(state, set));
  }
  return out;
}

std::map<std::string, Values> any_of(const Model& model, const std::vector<ConditionUse>& conditions) {
  std::map<std::string, Values> out;
  for (const auto& [id, set] : gathered(model, conditions, &ValueSet::united))
    out.emplace(model.states[id].name.value, values_of(model.states[id], set));
  return out;
}

std::optional<Span> place_of(const Model& model, const std::vector<ConditionUse>& conditions,
                             const std::string& state) {
  for (const ConditionUse& use : conditions) {
    if (model.states[model.conditions[use.id].state].name.value == state) return use.span;
  }
  return {};
}

} // namespace director::compiler::diff
