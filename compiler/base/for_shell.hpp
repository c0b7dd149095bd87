#pragma once
// SPDX-License-Identifier: MIT

#include <string>
#include <string_view>

namespace director::compiler {

/// The name of a file as a word of a command: in quotes if it needs them, and never like an option.
inline std::string for_shell(std::string_view text) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._/-+,:=@%";
  if (text.starts_with('-')) return for_shell("./" + std::string(text));
  if (!text.empty() && text.find_first_not_of(plain) == std::string_view::npos) return std::string(text);
  std::string out = "'";
  for (const char letter : text) out += letter == '\'' ? "'\\''" : std::string(1, letter);
  return out + "'";
}

} // namespace director::compiler
