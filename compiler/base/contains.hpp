#pragma once
// SPDX-License-Identifier: MIT

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

inline bool contains(const std::vector<std::string>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

} // namespace director::compiler
