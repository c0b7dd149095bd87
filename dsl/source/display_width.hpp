#pragma once
// SPDX-License-Identifier: MIT
// How many columns a character takes on a terminal: one, two (Chinese, emoji), or none (a combining accent). It is what
// the C library (wcwidth) returns in the locale C.UTF-8; without that locale every character takes one. Some terminals
// draw several characters as one, or newer characters with another width: there marks may be misplaced.

#include <cstddef>
#include <string_view>

namespace director::dsl {

struct Glyph {
  std::size_t bytes = 1;
  std::size_t columns = 1;
  bool printable = true; ///< false for control characters, and for a byte that is not UTF-8
};

/// Whether the byte is part of a UTF-8 character, but not its first.
constexpr bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// The character that begins at `text[at]`. `at` lies within `text`.
Glyph glyph_at(std::string_view text, std::size_t at);

} // namespace director::dsl
