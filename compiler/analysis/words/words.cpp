// Header: compiler/analysis/words/words.hpp. Test: tests/compiler/analysis/words/words_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

namespace director::analysis {

std::string quoted(std::string_view name) { return fmt::format("`{}`", name); }
std::string name_of(const Model& model, GroupId id) { return quoted(model.groups[id].name.value); }
std::string name_of(const Model& model, ProviderId id) { return quoted(model.distinct_name(id)); }
std::string name_of(const Model& model, ConditionId id) { return quoted(model.conditions[id].text); }
std::string name_of(const Model& model, StateId id) { return quoted(model.states[id].name.value); }

std::string few_of(const std::vector<std::string>& things, std::string_view last) {
  constexpr std::size_t few = 4;
  if (things.size() <= few + 1) return list_of(things, last);
  std::vector<std::string> out(things.begin(), things.begin() + few);
  out.push_back(fmt::format("{} more", things.size() - few));
  return list_of(out, last);
}

std::string values_in_words(const State& state, const ValueSet& values, bool unset) {
  std::vector<std::string> things;
  for (const ValueSet::Interval& interval : values.intervals()) {
    if (state.is_range && interval.low < interval.high) {
      things.push_back(fmt::format("{} to {}", interval.low, interval.high));
      continue;
    }
    for (std::int64_t value = interval.low; value <= interval.high; ++value) things.push_back(state.value_text(value));
  }
  if (unset) things.push_back("unset");
  return things.empty() ? "nothing" : list_of(things, "or");
}

std::string chain_in_words(const Model& model, const std::vector<GroupId>& chain, std::string_view verb) {
  constexpr std::size_t most = 12; // limit: the notes have all of them
  std::string out = name_of(model, chain.front());
  for (std::size_t i = 1; i < chain.size(); ++i) {
    if (chain.size() > most + 1 && i == most / 2) {
      const std::size_t left_out = chain.size() - 1 - most;
      out += fmt::format(", which by {} more leads to {}", left_out, name_of(model, chain[i + left_out]));
      i += left_out;
      continue;
    }
    out += fmt::format("{} {} {}", i == 1 ? "" : ", which", verb,
                       i == chain.size() - 1 && chain[i] == chain[0] && i > 1 ? name_of(model, chain[i]) + " again"
                                                                              : name_of(model, chain[i]));
  }
  return out;
}

} // namespace director::analysis
