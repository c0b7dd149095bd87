#pragma once
// SPDX-License-Identifier: MIT
// Text for a terminal: lines broken between words, and pages in Markdown without their marks.

#include <cstddef>
#include <string>
#include <string_view>

namespace director::compiler::cli {

/// The columns on a terminal, without escape sequences.
std::size_t columns_of(std::string_view text);

/// `text`, whose first line begins at column `begin`, in lines of at most `width` columns, without a line break at the
/// end. The other lines begin with `indent` blanks. A word is never broken: one that is too long has its own line.
std::string in_lines(std::string_view text, std::size_t width, std::size_t begin, std::size_t indent);

/// A page as `directorc explain` prints it on a terminal: paragraphs and items of lists broken at `width`, code four
/// columns to the right, with the comment of a line that is too wide below it, tables unchanged, links as their text.
std::string page_text(std::string_view markdown, std::size_t width, bool colours);

} // namespace director::compiler::cli
