#pragma once
// SPDX-License-Identifier: MIT
// "Did you mean": the known word that a misspelt one is nearest to.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::dsl {

/// The candidate with the fewest edits (insert, remove, replace or swap two neighbours; the case of a letter counts a
/// quarter); of several the first. Where even that one differs in more than a third of its letters, the only candidate
/// that begins with the word; else nothing.
std::optional<std::string> suggest(std::string_view word, const std::vector<std::string>& candidates);

/// Words that are compared with misspelt ones in a run, about.
inline constexpr std::size_t most_compared = 2'000'000;

/// Whether it is worth while to compare so many candidates, when so much was found already: where very much is
/// misspelt it was no slip of the pen.
constexpr bool is_slip(std::size_t candidates, std::size_t findings) { return candidates * findings <= most_compared; }

} // namespace director::dsl
