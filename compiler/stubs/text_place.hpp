#pragma once
// SPDX-License-Identifier: MIT
// Finds places in a text for insertions on lines of their own. Looks at one line only; Clang has analysed its meaning.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace director::compiler::stubs {

/// The line break of the file, as its first line has it: `\n` or `\r\n`.
std::string_view line_break(std::string_view text);

/// The blanks and tabs at the beginning of the line of the offset.
std::string_view indentation(std::string_view text, std::size_t offset);

/// The place behind something that ends at `end`: the end of its line if only a comment follows, which belongs to it;
/// otherwise `end`.
std::size_t behind(std::string_view text, std::size_t end);

/// The beginning of the line of the offset if there are only blanks before it; otherwise the offset.
std::size_t before(std::string_view text, std::size_t offset);

/// The offset of a line and column, in bytes from 1, as Clang counts them; the size of the text if there is no such
/// line.
std::size_t offset_at(std::string_view text, std::uint32_t line, std::uint32_t column);

/// The line of the offset, from 1.
std::uint32_t line_of(std::string_view text, std::size_t offset);

} // namespace director::compiler::stubs
