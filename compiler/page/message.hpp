#pragma once
// SPDX-License-Identifier: MIT
// The message of a finding on a page: it has code between backquotes.

#include <algorithm>
#include <string>
#include <string_view>

namespace director::compiler::page {

/// All pieces, each as `plain` or `code` makes it.
template <class Plain, class Code>
std::string in_pieces(std::string_view message, const Plain& plain, const Code& code) {
  std::string out;
  bool in_code = false;
  for (std::size_t at = 0; at <= message.size();) {
    const std::size_t end = std::min(message.find('`', at), message.size());
    const std::string_view piece = message.substr(at, end - at);
    out += in_code ? code(piece) : plain(piece);
    in_code = !in_code;
    at = end + 1;
  }
  return out;
}

} // namespace director::compiler::page
