// Header: dsl/source/harmless.hpp. Test: tests/dsl/source/harmless_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/source/harmless.hpp"

#include <fmt/format.h>

namespace director::dsl {

namespace {

unsigned byte_at(std::string_view text, std::size_t at) {
  return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
}

/// The character from U+2000 to U+207F at this place, as its number; 0 if there is none.
unsigned general_punctuation(std::string_view text, std::size_t at) {
  const unsigned second = byte_at(text, at + 1), third = byte_at(text, at + 2);
  const bool is_here =
      byte_at(text, at) == 0xE2U && (second == 0x80U || second == 0x81U) && third >= 0x80U && third < 0xC0U;
  return is_here ? 0x2000U + ((second & 0x3FU) << 6U) + (third & 0x3FU) : 0U;
}

/// Whether it is a mark, embedding, override or isolate of Unicode's bidirectional algorithm.
bool turns(unsigned character) {
  return character == 0x200EU || character == 0x200FU || (character >= 0x202AU && character <= 0x202EU) ||
         (character >= 0x2066U && character <= 0x2069U);
}

/// `kept`: control characters that remain.
std::string spelled_out(std::string_view text, std::string_view kept) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned byte = byte_at(text, i), next = byte_at(text, i + 1);
    const bool is_c1 = byte == 0xC2U && next >= 0x80U && next < 0xA0U; // U+0080 to U+009F
    if (is_c1) {
      out += fmt::format("\\x{:02X}", next);
      ++i;
    } else if (const unsigned character = general_punctuation(text, i); turns(character)) {
      out += fmt::format("\\u{:04X}", character);
      i += 2;
    } else if ((byte < 0x20U && kept.find(text[i]) == kept.npos) || byte == 0x7FU) {
      out += fmt::format("\\x{:02X}", byte);
    } else {
      out += text[i];
    }
  }
  return out;
}

} // namespace

std::string harmless(std::string_view text) { return spelled_out(text, ""); }

std::string harmless_lines(std::string_view text) { return spelled_out(text, "\n"); }

std::string harmless_code(std::string_view text) { return spelled_out(text, "\n\t"); }

} // namespace director::dsl
