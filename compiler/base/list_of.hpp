#pragma once
// SPDX-License-Identifier: MIT

#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

/// "a, b and c", or another last word than "and"; empty for none.
inline std::string list_of(const std::vector<std::string>& words, std::string_view last = "and") {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? " " + std::string(last) + " " : ", ";
    out += words[i];
  }
  return out;
}

} // namespace director::compiler
