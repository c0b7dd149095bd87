#pragma once
// SPDX-License-Identifier: MIT

#include <string>
#include <vector>

namespace director::compiler {

/// "a, b and c"; empty for none.
inline std::string and_list(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? " and " : ", ";
    out += words[i];
  }
  return out;
}

} // namespace director::compiler
