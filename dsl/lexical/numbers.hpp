#pragma once
// SPDX-License-Identifier: MIT
// Numbers of YAML's core schema, in one spelling each. The language's own numbers are stricter: parse_number().

#include <optional>
#include <string>
#include <string_view>

namespace director::dsl {

/// `0x1F`, `+007`: in decimal, without needless zeros. Nothing: the text is no whole number.
std::optional<std::string> integer_of_yaml(std::string_view text);

/// `1e3`, `.5`: the shortest way to write it, never without a point or an exponent. A whole number is one too.
std::optional<std::string> real_of_yaml(std::string_view text);

} // namespace director::dsl
