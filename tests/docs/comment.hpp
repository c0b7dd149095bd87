#pragma once
// SPDX-License-Identifier: MIT
// A comment of a page: `word, option 1, option "text": argument`, and further lines.

#include <map>
#include <string>
#include <string_view>

namespace director::tests {

struct Comment {
  std::string word;                           ///< or several: `not run`
  std::map<std::string, std::string> options; ///< without the quotation marks
  std::string argument;                       ///< behind the colon
  std::string rest;                           ///< the lines after the first
};

Comment read_comment(std::string_view text);

} // namespace director::tests
