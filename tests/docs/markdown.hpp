#pragma once
// SPDX-License-Identifier: MIT
// A page in Markdown, parsed as far as its tests need it. Unit: lines, from 0. Errors: none; what is not recognised is
// text.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace director::tests {

using Lines = std::vector<std::string>;

Lines lines_of(std::string_view text);
std::string text_of(const Lines& lines);

/// A fenced block, or a picture: what a comment directly before it can refer to.
struct Block {
  std::string comment; ///< without its brackets; empty: there is none
  std::size_t line = 0;
  Lines lines; ///< between the fences
};
struct Picture {
  std::string comment;
  std::size_t line = 0;
  std::string target;
};

/// Something within a line: the target of a link (a picture's too), or the text between backticks.
struct Inline {
  std::size_t line = 0;
  std::string text;
};

struct Markdown {
  Lines lines;
  std::vector<Block> blocks;
  std::vector<Picture> pictures;
  std::vector<Inline> links;
  std::vector<Inline> code;
  std::vector<Inline> indented; ///< blocks that are code by their indentation alone
  Lines anchors;                ///< of the headings
};

Markdown read_markdown(std::string_view text);

/// The page with other lines in its blocks, one entry for each.
std::string with_blocks(const Markdown& page, const std::vector<Lines>& blocks);

} // namespace director::tests
