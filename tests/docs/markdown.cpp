// Header: tests/docs/markdown.hpp. Test: tests/docs/markdown_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/docs/markdown.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

namespace director::tests {

namespace {

std::string without_margin(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \n");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \n") - first + 1));
}

bool is_fence(std::string_view line) { return line.starts_with("```"); }

/// GitHub's anchor for a heading.
std::string anchor_of(std::string_view heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ')
      anchor += '-';
    else if (byte >= 0x80 || std::isalnum(byte) != 0 || c == '-' || c == '_')
      anchor += static_cast<char>(std::tolower(byte));
  }
  return anchor;
}

class Reader {
public:
  Markdown read(std::string_view text) {
    page_.lines = lines_of(text);
    for (at_ = 0; at_ < page_.lines.size(); ++at_) line(page_.lines[at_]);
    return std::move(page_);
  }

private:
  void line(const std::string& line) {
    const bool after_blank = std::exchange(blank_, without_margin(line).empty());
    if (blank_) return;
    if (line.starts_with("<!--")) return comment();
    const std::string before = std::exchange(comment_, {});
    if (is_fence(line)) return block(before);
    if (line.starts_with("    ") && after_blank) page_.indented.push_back({at_, line});
    if (line.starts_with("#")) heading(without_margin(line.substr(line.find_first_not_of('#'))));
    words(line, before);
  }

  void comment() {
    std::string text = page_.lines[at_].substr(4);
    while (text.find("-->") == std::string::npos && at_ + 1 < page_.lines.size()) text += "\n" + page_.lines[++at_];
    comment_ = without_margin(std::string_view(text).substr(0, text.find("-->")));
  }

  void block(const std::string& before) {
    Block block{before, at_, {}};
    while (++at_ < page_.lines.size() && !is_fence(page_.lines[at_])) block.lines.push_back(page_.lines[at_]);
    page_.blocks.push_back(std::move(block));
  }

  void heading(const std::string& text) {
    const std::string anchor = anchor_of(text);
    const auto same = std::ranges::count(plain_anchors_, anchor);
    plain_anchors_.push_back(anchor);
    page_.anchors.push_back(same == 0 ? anchor : anchor + "-" + std::to_string(same));
  }

  void words(std::string_view line, const std::string& before) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '`') {
        const std::size_t end = line.find('`', i + 1);
        if (end == std::string_view::npos) return;
        page_.code.push_back({at_, std::string(line.substr(i + 1, end - i - 1))});
        i = end;
      } else if (line.substr(i).starts_with("](")) {
        const std::size_t end = line.find(')', i);
        if (end == std::string_view::npos) return;
        const std::string target(line.substr(i + 2, end - i - 2));
        page_.links.push_back({at_, target});
        if (line.starts_with("![")) page_.pictures.push_back({before, at_, target});
      }
    }
  }

  Markdown page_;
  std::size_t at_ = 0;
  bool blank_ = true;
  std::string comment_; ///< above this line
  Lines plain_anchors_;
};

} // namespace

Lines lines_of(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string text_of(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

Markdown read_markdown(std::string_view text) { return Reader{}.read(text); }

std::string with_blocks(const Markdown& page, const std::vector<Lines>& blocks) {
  Lines lines;
  std::size_t next = 0;
  for (std::size_t i = 0; i < page.blocks.size(); ++i) {
    const Block& block = page.blocks[i];
    const auto from = page.lines.begin();
    lines.insert(lines.end(), from + static_cast<std::ptrdiff_t>(next),
                 from + static_cast<std::ptrdiff_t>(block.line + 1));
    lines.insert(lines.end(), blocks[i].begin(), blocks[i].end());
    next = block.line + 1 + block.lines.size();
  }
  lines.insert(lines.end(), page.lines.begin() + static_cast<std::ptrdiff_t>(next), page.lines.end());
  return text_of(lines);
}

} // namespace director::tests
