#pragma once
// SPDX-License-Identifier: MIT
// The meaning of conditions, independent of their spelling and of the numbers of their values: the values of each
// state, by name.

#include "compiler/model/model.hpp"

#include <map>
#include <string>
#include <vector>

namespace director::compiler::diff {

/// Some values of one state.
struct Values {
  bool is_range = false;
  ValueSet range;                 ///< of integers
  std::vector<std::string> words; ///< sorted
  bool operator==(const Values&) const = default;
  bool empty() const { return is_range ? range.empty() : words.empty(); }
};

Values values_of(const State& state, const ValueSet& set);
/// The values of the first that the second does not have; all of them if only one is a range.
Values without(const Values& first, const Values& second);
/// `ready|set`, `30..100`
std::string to_text(const Values& values);

/// By name of the state. The conjunction; what always holds is left out.
std::map<std::string, Values> all_of(const Model& model, const std::vector<ConditionUse>& conditions);
/// By name of the state. The disjunction.
std::map<std::string, Values> any_of(const Model& model, const std::vector<ConditionUse>& conditions);

/// The place of the first condition on this state; empty if there is none.
std::optional<Span> place_of(const Model& model, const std::vector<ConditionUse>& conditions, const std::string& state);

} // namespace director::compiler::diff
