#pragma once
// SPDX-License-Identifier: MIT

#include <string>
#include <string_view>

namespace director::compiler {

/// For the text between tags, and for what stands between double quotes in one; in labels of the DOT language too.
std::string html(std::string_view text);

} // namespace director::compiler
