#pragma once
// SPDX-License-Identifier: MIT
// Colours of a terminal (ECMA-48, SGR). Each colour has one meaning wherever text is printed; nothing is shown by
// colour alone.

#include <string>
#include <string_view>

namespace director::dsl {

namespace colours {
inline constexpr std::string_view reset = "\033[0m", bold = "\033[1m";
inline constexpr std::string_view red = "\033[31m", green = "\033[32m", blue = "\033[34m", cyan = "\033[36m";
inline constexpr std::string_view grey = "\033[90m", bold_red = "\033[1;31m", bold_green = "\033[1;32m";
inline constexpr std::string_view bold_blue = "\033[1;34m", bold_magenta = "\033[1;35m", bold_cyan = "\033[1;36m";
} // namespace colours

/// `text` in a colour; unchanged without colours, or if the colour is empty.
inline std::string painted(std::string_view text, std::string_view colour, bool has_colours) {
  if (!has_colours || colour.empty()) return std::string(text);
  return std::string(colour).append(text).append(colours::reset);
}

} // namespace director::dsl
