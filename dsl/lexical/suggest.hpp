#pragma once
// SPDX-License-Identifier: MIT
// "Did you mean": the known word nearest to a misspelt one.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::dsl {

/// The candidate with the fewest edits (insert, remove, replace or swap two neighbours; the case of a letter counts a
/// quarter); the first of several. If that differs in more than a third of its letters: the only candidate that begins
/// with the word, if there is one.
std::optional<std::string> suggest(std::string_view word, const std::vector<std::string>& candidates);

/// Approximate limit for comparisons with misspelt words in one run.
inline constexpr std::size_t most_compared = 2'000'000;

/// Whether comparing so many candidates is worth its time after so many findings: a file with very many unknown words
/// has another cause than misspelling.
constexpr bool is_slip(std::size_t candidates, std::size_t findings) { return candidates * findings <= most_compared; }

} // namespace director::dsl
