#pragma once
// SPDX-License-Identifier: MIT

#include <string>
#include <string_view>

namespace director::compiler {

/// Characters that XML and the DOT language cannot represent become blanks, as in the comments of C++.
std::string without_controls(std::string_view text);
/// For the text between tags.
std::string html(std::string_view text);
/// For an attribute between double quotes, also in labels of the DOT language: line breaks are kept.
std::string html_attribute(std::string_view text);

} // namespace director::compiler
