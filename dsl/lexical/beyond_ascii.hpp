#pragma once
// SPDX-License-Identifier: MIT
// Characters that no name can have, but that look like one of those that it can, or like nothing.

#include <string>
#include <string_view>

namespace director::dsl {

/// The first character beyond ASCII, as `U+200B`; empty if there is none.
std::string first_beyond_ascii(std::string_view text);

/// What to write for a character that looks like a blank or a colon, copied from a page; empty if there is none.
std::string help_for_look_alike(std::string_view text);

} // namespace director::dsl
