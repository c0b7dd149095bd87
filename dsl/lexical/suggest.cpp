// Header: dsl/lexical/suggest.hpp. Test: tests/dsl/lexical/suggest_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/lexical/suggest.hpp"

#include "dsl/lexical/characters.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace director::dsl {

namespace {

/// Limit for compared words: real names are shorter, and longer words only cost time.
constexpr std::size_t longest = 100;

/// The cost of an edit; that of a letter in the wrong case is 1.
constexpr std::size_t edit = 4;

std::size_t distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> two_above(width), above(width), row(width);
  for (std::size_t j = 0; j < width; ++j) row[j] = edit * j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(two_above, above);
    std::swap(above, row);
    row[0] = edit * i;
    for (std::size_t j = 1; j < width; ++j) {
      const char x = a[i - 1], y = b[j - 1];
      const std::size_t replace = x == y ? 0 : lower(x) == lower(y) ? 1 : edit;
      row[j] = std::min({above[j] + edit, row[j - 1] + edit, above[j - 1] + replace});
      if (i > 1 && j > 1 && x == b[j - 2] && a[i - 2] == y && x != y)
        row[j] = std::min(row[j], two_above[j - 2] + edit);
    }
  }
  return row.back();
}

/// The only candidate that begins with the word.
std::optional<std::string> continued(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t shortest = 3;
  const auto begins_so = [&](const std::string& candidate) { return candidate.starts_with(word) && candidate != word; };
  const auto first = std::find_if(candidates.begin(), candidates.end(), begins_so);
  if (word.size() < shortest || first == candidates.end()) return {};
  return std::find_if(std::next(first), candidates.end(), begins_so) == candidates.end() ? std::optional(*first)
                                                                                         : std::nullopt;
}

} // namespace

std::optional<std::string> suggest(std::string_view word, const std::vector<std::string>& candidates) {
  std::optional<std::string> best;
  std::size_t least = 0;
  if (word.size() > longest) return best;
  for (const std::string& candidate : candidates) {
    const std::size_t length = std::max(word.size(), candidate.size());
    if (candidate.size() > longest || candidate == word) continue;
    const std::size_t edits = distance(word, candidate);
    // At most a third of the letters may differ; a word of one or two letters may differ in the case only.
    if (edits * 3 > edit * std::max<std::size_t>(length, 1) || (best && edits >= least)) continue;
    best = candidate;
    least = edits;
  }
  return best ? best : continued(word, candidates);
}

} // namespace director::dsl
