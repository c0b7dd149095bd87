#pragma once
// SPDX-License-Identifier: MIT
// Text in Markdown, so that viewers show it as it is.

#include <string>
#include <string_view>

namespace director::compiler::page {

/// Text between tags and in cells of tables.
std::string escaped(std::string_view text);

/// Text at the beginning of a line, where a dash or a number would begin a list.
std::string escaped_line(std::string_view text);

/// Not for cells of a table.
std::string code(std::string_view text);

/// A message whose names are in backquotes.
std::string message(std::string_view text);

} // namespace director::compiler::page
