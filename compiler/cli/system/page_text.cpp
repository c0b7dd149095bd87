// Header: compiler/cli/system/page_text.hpp. Test: tests/compiler/cli/system/page_text_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/system/page_text.hpp"

#include "dsl/source/colours.hpp"
#include "dsl/source/display_width.hpp"

#include <algorithm>
#include <utility>

namespace director::compiler::cli {

namespace {

using dsl::colours::bold, dsl::colours::reset;
constexpr std::string_view code = dsl::colours::cyan;

/// Text without the marks of Markdown; each word has its own colours, so that lines can be broken between any two.
class Inline {
public:
  explicit Inline(bool colours) : colours_(colours) {}

  std::string of(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) at += step(text, at);
    end_style();
    return std::move(out_);
  }

private:
  /// Returns how many bytes were consumed.
  std::size_t step(std::string_view text, std::size_t at) {
    const std::string_view rest = text.substr(at);
    if (rest.front() == ' ') {
      const std::string_view style = style_;
      end_style();
      out_ += ' ';
      begin_style(style);
      return 1;
    }
    if (rest.front() == '`') {
      if (!colours_) out_ += '`';
      toggle(code);
      return 1;
    }
    if (style_ != code && rest.starts_with("**")) {
      toggle(bold);
      return 2;
    }
    if (style_ != code && rest.front() == '[') return link(rest);
    out_ += rest.front();
    return 1;
  }

  /// `[text](target)`: the text.
  std::size_t link(std::string_view rest) {
    const std::size_t middle = rest.find("](");
    const std::size_t end = middle == std::string_view::npos ? middle : rest.find(')', middle);
    if (end == std::string_view::npos) {
      out_ += '[';
      return 1;
    }
    const std::string_view text = rest.substr(1, middle - 1);
    for (std::size_t at = 0; at < text.size();) at += step(text, at);
    return end + 1;
  }

  void toggle(std::string_view style) {
    const bool ends = style_ == style;
    end_style();
    if (!ends) begin_style(style);
  }
  void begin_style(std::string_view style) {
    style_ = style;
    if (colours_) out_ += style_;
  }
  void end_style() {
    if (colours_ && !style_.empty()) out_ += reset;
    style_ = {};
  }

  bool colours_;
  std::string out_;
  std::string_view style_; ///< what the next character has
};

class Page {
public:
  Page(std::size_t width, bool colours) : width_(width), colours_(colours) {}

  std::string of(std::string_view markdown) {
    while (!markdown.empty()) {
      const std::size_t end = std::min(markdown.find('\n'), markdown.size());
      line(markdown.substr(0, end));
      markdown.remove_prefix(std::min(end + 1, markdown.size()));
    }
    finish();
    while (out_.ends_with("\n\n")) out_.pop_back();
    return std::move(out_);
  }

private:
  void line(std::string_view text) {
    if (text.starts_with("```")) {
      finish();
      if (!in_code_ && after_code_) out_ += '\n'; // one block below another
      after_code_ = in_code_;
      in_code_ = !in_code_;
      return;
    } else if (in_code_) {
      out_ += text.empty() ? "\n" : code_lines("    " + std::string(text)) + "\n";
    } else if (text.empty()) {
      finish();
      if (!out_.empty() && !out_.ends_with("\n\n")) out_ += '\n';
    } else if (text.starts_with('#')) {
      finish();
      text.remove_prefix(std::min(text.find_first_not_of("# "), text.size()));
      out_ += colours_ ? std::string(bold) + std::string(text) + std::string(reset) : std::string(text);
      out_ += '\n';
      in_head_ = true;
      return;
    } else if (text.starts_with('|')) {
      finish();
      out_ += std::string(text) + "\n";
    } else if (text.starts_with("- ")) {
      finish();
      indent_ = 2;
      paragraph_ = text;
    } else if (in_head_ && text.find(": ") != std::string_view::npos && paragraph_.empty()) {
      out_ += in_lines(text, width_, 0, 2) + "\n"; // `Level: error`, a line for each
      return;
    } else {
      if (!paragraph_.empty()) paragraph_ += ' ';
      text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
      paragraph_ += text;
    }
    in_head_ = false;
    after_code_ = after_code_ && in_code_;
  }

  void finish() {
    if (!paragraph_.empty()) out_ += in_lines(Inline(colours_).of(paragraph_), width_, 0, indent_) + "\n";
    paragraph_.clear();
    indent_ = 0;
  }

  /// A line that is too wide has its comment below it, indented. Without a comment it is broken between words.
  std::string code_lines(std::string line) const {
    if (columns_of(line) <= width_) return line;
    const std::size_t begin = line.find_first_not_of(' '), mark = line.find("# "), from = begin + 2;
    const auto comment = [&](std::size_t at) {
      // Each of its lines is a comment.
      const std::size_t room = width_ > from + 2 ? width_ - from - 2 : 1;
      std::string out = in_lines(std::string_view(line).substr(mark + 2), room, 0, 0);
      const std::string next = "\n" + std::string(at, ' ') + "# ";
      for (std::size_t end = out.find('\n'); end != std::string::npos; end = out.find('\n', end + next.size()))
        out.replace(end, 1, next);
      return std::string(at, ' ') + "# " + out;
    };
    if (mark == begin) return comment(begin);
    const std::string_view before = std::string_view(line).substr(0, mark);
    std::string out = std::string(begin, ' ') + in_lines(before.substr(begin), width_, begin, from + 2);
    return mark == std::string::npos ? out : out + "\n" + comment(from);
  }

  std::size_t width_;
  bool colours_;
  std::string out_, paragraph_;
  std::size_t indent_ = 0;
  bool in_code_ = false;
  bool in_head_ = false;    ///< right below a heading
  bool after_code_ = false; ///< right below a block of code
};

} // namespace

std::size_t columns_of(std::string_view word) {
  std::size_t out = 0;
  for (std::size_t at = 0; at < word.size();) {
    if (word[at] == '\033') {
      at = std::min(word.find('m', at), word.size() - 1) + 1;
      continue;
    }
    const dsl::Glyph glyph = dsl::glyph_at(word, at);
    out += glyph.columns;
    at += glyph.bytes;
  }
  return out;
}

std::string in_lines(std::string_view text, std::size_t width, std::size_t begin, std::size_t indent) {
  std::string out;
  std::size_t column = begin;
  bool at_begin = true; // of a line
  while (!text.empty()) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    const std::string_view word = text.substr(0, std::min(text.find(' '), text.size()));
    text.remove_prefix(word.size());
    if (word.empty()) break;
    const std::size_t wide = columns_of(word);
    if (!at_begin && column + 1 + wide > width) {
      out += '\n' + std::string(indent, ' ');
      column = indent;
      at_begin = true;
    }
    if (!at_begin) {
      out += ' ';
      ++column;
    }
    out += word;
    column += wide;
    at_begin = false;
  }
  return out;
}

std::string page_text(std::string_view markdown, std::size_t width, bool colours) {
  return Page(width, colours).of(markdown);
}

} // namespace director::compiler::cli
