#pragma once
// SPDX-License-Identifier: MIT
// How many columns a character takes on a terminal: one, two (Chinese, emoji), or none (an accent on the one before).
// As the C library says (wcwidth), in the locale C.UTF-8; without that locale every character takes one.
// Some terminals draw several characters as one picture, or newer ones otherwise: there marks may stand beside their
// place.

#include <cstddef>
#include <string_view>

namespace director::dsl {

struct Glyph {
  std::size_t bytes = 1;
  std::size_t columns = 1;
  bool printable = true; ///< false for control characters, and for a byte that is not UTF-8
};

/// It is a byte of a character of UTF-8, and not the first one.
constexpr bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// The character that begins at `text[at]`. `at` lies within `text`.
Glyph glyph_at(std::string_view text, std::size_t at);

} // namespace director::dsl
