#pragma once
// SPDX-License-Identifier: MIT
// Where in a text something can be put so that it stands on lines of its own. Looks at one line of it only; what its
// words mean, Clang has said.

#include <cstddef>
#include <string>
#include <string_view>

namespace director::compiler::stubs {

/// How the file ends its lines: as its first line does, "\n" or "\r\n".
std::string_view line_break(std::string_view text);

/// The blanks and tabs at the beginning of the line that the offset lies in.
std::string_view indentation(std::string_view text, std::size_t offset);

/// Behind something that ends at `end`: the end of its line if only a comment follows, which is its own; else `end`.
std::size_t behind(std::string_view text, std::size_t end);

/// The beginning of the line that the offset lies in if there are only blanks before it; else the offset.
std::size_t before(std::string_view text, std::size_t offset);

} // namespace director::compiler::stubs
