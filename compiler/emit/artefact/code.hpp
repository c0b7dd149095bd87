#pragma once
// SPDX-License-Identifier: MIT
// Generated code as a value: lines with their indent, wrapped to the page width when they are added, so that no caller
// handles line breaks. A line may have the place of the specification that it comes from; the manifest lists these.

#include "dsl/source/span.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

class Code {
public:
  static constexpr std::size_t width = 120;

  struct Line {
    std::uint32_t indent = 0; ///< levels of two blanks
    std::string text;         ///< without indent and line break; empty: a blank line
    std::optional<dsl::Span> from;
    bool operator==(const Line&) const = default;
  };

  void line(std::string_view text);
  void line(std::string_view text, const dsl::Span& from);
  /// Adds one blank line, never two and none behind an opening brace.
  void blank();
  /// Adds `text` and indents what follows, until close().
  void open(std::string_view text);
  void open(std::string_view text, const dsl::Span& from);
  void close(std::string_view text);
  /// Adds `text` as comment lines with `// ` or `/// `, broken between words.
  void comment(std::string_view text, std::string_view mark = "///");
  /// A line at the indent of the enclosing block: `public:`, `case`.
  void outdented(std::string_view text);
  /// `head item, item, item tail` on one line if it fits, otherwise broken between items, one level deeper.
  void list(std::string_view head, const std::vector<std::string>& items, std::string_view tail,
            const std::optional<dsl::Span>& from = {});
  /// The same, and indents what follows, until close().
  void open_list(std::string_view head, const std::vector<std::string>& items, std::string_view tail);
  /// Adds lines unchanged; each two blanks at the beginning of one are a level.
  void block(std::string_view text);
  /// Adds another piece of code, at this indent.
  void append(const Code& other);

  const std::vector<Line>& lines() const { return lines_; }
  std::string text() const;

private:
  void list_below(const std::vector<std::string>& items, std::string_view tail);
  std::size_t room() const { return width - 2 * indent_; }

  std::vector<Line> lines_;
  std::uint32_t indent_ = 0;
};

/// Text that is safe in a comment: without control characters and marks that change the direction of text.
std::string as_comment(std::string_view text);

} // namespace director::compiler
