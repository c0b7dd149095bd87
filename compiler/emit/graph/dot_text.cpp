// Header: compiler/emit/graph/dot_text.hpp. Test: tests/compiler/emit/graph/picture/picture_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/dot_text.hpp"

#include "compiler/base/html.hpp"
#include "compiler/base/percent.hpp"
#include "compiler/emit/graph/palette.hpp"
#include "dsl/source/shortened.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

/// No address contains these (RFC 3986, appendix C), and in every format they would end it.
std::string without_delimiters(std::string_view address) {
  std::string out;
  for (const char letter : address) {
    const bool ends = letter == '"' || letter == '<' || letter == '>' || letter == ' ';
    out += ends ? percent_encoded({&letter, 1}, {}) : std::string(1, letter);
  }
  return out;
}

} // namespace

std::string PictureLinks::to(const PictureText& text) const {
  if (pattern.empty() || text.file.empty()) return {};
  std::string out = pattern;
  const auto put = [&](std::string_view name, const std::string& value) {
    for (std::size_t at = out.find(name); at != std::string::npos; at = out.find(name, at + value.size()))
      out.replace(at, name.size(), value);
  };
  put("{line}", std::to_string(text.line));
  put("{file}", percent_encoded(text.file, "-._~/")); // in Markdown too nothing of it has a meaning
  return without_delimiters(out);
}

namespace {

/// Graphviz reads strings of up to 16 KiB, and more than a page is not read in a tooltip. It also replaces `\N` and
/// the like by names.
std::string tooltip(const PictureText& text) {
  const std::string words = dsl::shortened(text.words);
  std::string out;
  for (const char letter : text.file.empty() ? words : fmt::format("{}\n{}:{}", words, text.file, text.line))
    out += letter == '\\' ? "\\\\" : std::string(1, letter);
  return out;
}

} // namespace

/// Not of a cell: Graphviz replaces `&amp;` there.
std::string quoted_tooltip(const PictureText& text) {
  std::string out;
  for (const char letter : tooltip(text)) out += letter == '&' ? "&amp;" : std::string(1, letter);
  return palette::in_quotes(out);
}

/// Graphviz writes the tooltip of a cell only if this has a link or a target.
std::string cell_words(const PictureText& text, const PictureLinks& links) {
  const std::string url = links.to(text);
  return fmt::format(" TOOLTIP=\"{}\"{}", html_attribute(tooltip(text)),
                     url.empty() ? " TARGET=\"_top\"" : fmt::format(" HREF=\"{}\"", html_attribute(url)));
}

std::string port(const PictureRow& row) { return row.name; }
std::string port(const PictureRow& row, const PicturePack& pack) {
  return row.name.empty() ? pack.name : row.name + "." + pack.name;
}
std::string port(const Picture& picture, const PictureEnd& end) {
  if (!end.row && !end.pack) return {};
  const PictureRow& row = picture.boxes[end.box].rows[end.row.value_or(0)];
  return end.pack ? port(row, row.packs[*end.pack]) : port(row);
}

std::string label_text(const PictureArrow& arrow) {
  const std::string_view comma = arrow.label.empty() ? "" : ", ";
  return arrow.apart && !arrow.optional ? fmt::format("{}{}apart", arrow.label, comma) : arrow.label;
}

} // namespace director::compiler
