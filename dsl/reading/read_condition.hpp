#pragma once
// SPDX-License-Identifier: MIT
// Reads conditions, `<State> <op> <value>`. Source: docs/language.md, "Conditions". Finds bad_condition, whose place is
// the word inside the condition that is wrong.

#include "dsl/reading/reader.hpp"
#include "dsl/spec.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::dsl {

/// `when` and `stay` have plain comparisons; `causing` may have `within 2 s`; `sets` may name a state alone.
enum class ConditionUse { comparison, causing, sets };

std::optional<ConditionSpec> read_condition(Reader& reader, const YamlNode& node, std::string_view subject,
                                            ConditionUse use);
/// The conditions of a list, without those that are wrong.
std::vector<ConditionSpec> read_conditions(Reader& reader, const YamlNode* node, std::string_view subject,
                                           ConditionUse use);

/// The operator for the comparison with its sides exchanged.
Op turned(Op op);
std::string_view to_text(Op op);
/// The normal form: `Phase == ready|set`, `Pose == standing within 2 s`.
std::string to_text(const ConditionSpec& condition);

} // namespace director::dsl
