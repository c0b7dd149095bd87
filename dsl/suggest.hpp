#pragma once
// SPDX-License-Identifier: MIT
// "Did you mean": the known word that a misspelt one is nearest to.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::dsl {

/// The candidate with the fewest edits (insert, remove, replace or swap two neighbours; the case of a letter counts a
/// quarter); of several the first. Nothing where even that one differs in more than a third of its letters.
std::optional<std::string> suggest(std::string_view word, const std::vector<std::string>& candidates);

} // namespace director::dsl
