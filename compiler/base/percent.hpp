#pragma once
// SPDX-License-Identifier: MIT
// Percent-encoding, for paths in addresses (RFC 3986, section 2.1).

#include "dsl/lexical/characters.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace director::compiler {

/// All but letters, digits and those in `plain` as `%20`.
inline std::string percent_encoded(std::string_view text, std::string_view plain) {
  std::string out;
  for (const char letter : text) {
    if (dsl::is_alphanumeric(letter) || plain.find(letter) != std::string_view::npos) {
      out += letter;
    } else {
      out += fmt::format("%{:02X}", static_cast<unsigned char>(letter));
    }
  }
  return out;
}

} // namespace director::compiler
