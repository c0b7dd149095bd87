#pragma once
// SPDX-License-Identifier: MIT

#include <string>
#include <string_view>

namespace director::compiler {

/// Replaces each occurrence, from the front; what is put in is not searched again.
inline void replace_all(std::string& text, std::string_view old, std::string_view with) {
  std::string out;
  std::size_t from = 0;
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, from)) {
    out.append(text, from, at - from);
    out += with;
    from = at + old.size();
  }
  text = out.append(text, from);
}

} // namespace director::compiler
