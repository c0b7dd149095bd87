// Header: dsl/lexical/beyond_ascii.hpp. Test: tests/dsl/lexical/beyond_ascii_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/lexical/beyond_ascii.hpp"

#include "dsl/lexical/characters.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace director::dsl {

std::string first_beyond_ascii(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto lead = static_cast<unsigned char>(text[at]);
    if (lead < 0x80U) continue;
    const std::size_t length = utf8_length(text, at);
    if (length == 0) return fmt::format("\\x{:02X}", lead); // no file has it: not UTF-8
    unsigned code = lead & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) code = (code << 6U) | (static_cast<unsigned char>(text[at + i]) & 0x3FU);
    return fmt::format("U+{:04X}", code);
  }
  return "";
}

std::string help_for_look_alike(std::string_view text) {
  if (text.find("\xC2\xA0") != std::string_view::npos)
    return "it has no-break spaces in it: write blanks in their place";
  if (text.find("\xEF\xBC\x9A") != std::string_view::npos) return "it has a full-width colon in it: write `: `";
  return "";
}

} // namespace director::dsl
