#pragma once
// SPDX-License-Identifier: MIT
// Text of a user's, which may hold anything, as a terminal may have it.

#include <string>
#include <string_view>

namespace director::dsl {

/// What would move a terminal's cursor, change its colours or turn the direction of what stands behind it is spelled
/// out: `\x1B`, `\u202E`.
std::string harmless(std::string_view text);

/// The same of a text of several lines, which stay lines.
std::string harmless_lines(std::string_view text);

/// The same of what a file says, whose tabs stay tabs too.
std::string harmless_code(std::string_view text);

} // namespace director::dsl
