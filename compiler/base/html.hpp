#pragma once
// SPDX-License-Identifier: MIT

#include <string>
#include <string_view>

namespace director::compiler {

/// For the text between tags.
std::string html(std::string_view text);
/// For an attribute between double quotes, in labels of the DOT language too: the ends of lines are kept.
std::string html_attribute(std::string_view text);

} // namespace director::compiler
