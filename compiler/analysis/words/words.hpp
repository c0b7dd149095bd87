#pragma once
// SPDX-License-Identifier: MIT
// The wording of things in messages.

#include "compiler/base/list_of.hpp"
#include "compiler/model/model.hpp"

#include <string>
#include <vector>

namespace director::analysis {

using namespace director::compiler;

std::string quoted(std::string_view name);           ///< `Walk`
std::string name_of(const Model& model, GroupId id); ///< `Walk`, quoted, as all of these
std::string name_of(const Model& model, ProviderId id);
std::string name_of(const Model& model, ConditionId id);
std::string name_of(const Model& model, StateId id);

/// As list_of(), but of a long list the first ones and the count of the rest.
std::string few_of(const std::vector<std::string>& things, std::string_view last = "and");

/// Values in plain words: "fallen or standing", "0 to 10, 50 or unset"; nothing: "nothing".
std::string values_in_words(const compiler::State& state, const ValueSet& values, bool unset = false);

/// A group that leads to the next one, over needs or requests: "`A` needs `B`, which needs `C`".
std::string chain_in_words(const Model& model, const std::vector<GroupId>& chain, std::string_view verb);

} // namespace director::analysis
