#pragma once
// SPDX-License-Identifier: MIT
// Writes YAML that read_yaml reads back unchanged: words and texts, quoted where needed.

#include <string>
#include <string_view>
#include <vector>

namespace director::dsl {

/// The word, valid at any place, also in brackets.
std::string yaml_word(std::string_view text);

/// `[a, b]`
std::string yaml_list(const std::vector<std::string>& items);

/// `{a: 1, b: 2}`; the pairs are written already.
std::string yaml_mapping(const std::vector<std::string>& pairs);

} // namespace director::dsl
