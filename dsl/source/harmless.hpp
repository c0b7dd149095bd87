#pragma once
// SPDX-License-Identifier: MIT
// Makes text from a user, which may have any bytes, safe for a terminal.

#include <string>
#include <string_view>

namespace director::dsl {

/// Escapes what would move a terminal's cursor, change its colours or turn the direction of the text after it: `\x1B`,
/// `\u202E`.
std::string harmless(std::string_view text);

/// The same for a text of several lines, which remain lines.
std::string harmless_lines(std::string_view text);

/// The same for the content of a file, which also keeps its tabs.
std::string harmless_code(std::string_view text);

} // namespace director::dsl
