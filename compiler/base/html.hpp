#pragma once
// SPDX-License-Identifier: MIT

#include <string>
#include <string_view>

namespace director::compiler {

/// What XML, and the DOT language, cannot hold is a blank, as in the comments of C++.
std::string without_controls(std::string_view text);
/// For the text between tags.
std::string html(std::string_view text);
/// For an attribute between double quotes, in labels of the DOT language too: the ends of lines are kept.
std::string html_attribute(std::string_view text);

} // namespace director::compiler
