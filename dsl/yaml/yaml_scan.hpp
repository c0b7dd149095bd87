#pragma once
// SPDX-License-Identifier: MIT
// Scans YAML text for what yaml-cpp does not report: forbidden bytes, tabs, and where things end. Offsets are bytes of
// `text`.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::dsl::yaml_scan {

struct Fault {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string message;
  std::string help;
};

/// The first forbidden byte: not UTF-8, a NUL or another control character, a byte order mark.
std::optional<Fault> forbidden_bytes(std::string_view text);

/// The first line that a version control system wrote between the two sides of a conflict. No YAML has such a line,
/// except in quotes.
std::optional<Fault> conflict_marker(std::string_view text);

/// The first tab in the line's indentation, unless only a comment or the end of the line follows. `at` is any place in
/// the line.
std::optional<std::size_t> tab_in_indentation(std::string_view text, std::size_t at);

/// The offset behind the closing quote; empty if there is none. `begin` is at the opening one.
std::optional<std::size_t> end_of_quoted(std::string_view text, std::size_t begin);

/// The first quote from `from` on that opens a scalar and is never closed.
std::optional<std::size_t> unclosed_quote(std::string_view text, std::size_t from);

/// A word that was meant as a key: `needs [Legs]`, or `needs:[Legs]`, which YAML reads as text that continues in the
/// next line.
struct BareKey {
  std::size_t begin = 0, end = 0;
  bool blank = false; ///< the colon is there, and the blank behind it is not
};
/// The bare key above a `:` that belongs to no key. `at`: that colon.
std::optional<BareKey> bare_key_above(std::string_view text, std::size_t at);

/// The bare key before a bracket, in a mapping between brackets: `{needs [Legs]}`, `{needs:[Legs]}`. `at`: the second
/// bracket.
std::optional<BareKey> bare_key_before(std::string_view text, std::size_t at);

/// The bare key before the bracket in whose content `at` is, in one line: `Walk:{needs: [Legs]}`. YAML reads such a
/// bracket as text, and what closes it as closing nothing.
std::optional<BareKey> bare_key_with_bracket(std::string_view text, std::size_t at);

/// The key at the beginning of what YAML reads as one text, `every:10 ms`.
std::optional<BareKey> bare_key_in(std::string_view text, std::size_t begin, std::size_t end);

/// The limit of YAML for a key with its colon in the same line.
constexpr std::size_t longest_key = 1024;
/// The first text of a line, or the text from `from` between brackets, if its colon is in the same line and it is
/// longer than a key may be. `at`: where the parser stopped.
std::optional<BareKey> too_long_key(std::string_view text, std::size_t from, std::size_t at);

/// Whether both are the first in their lines, and the first one is not indented deeper.
bool begins_line_before(std::string_view text, std::size_t first, std::size_t second);

/// The offset behind blanks, line breaks and comments.
std::size_t skip_blanks(std::string_view text, std::size_t at);

/// The places in the text of the bytes of a plain scalar's value, and, last, of its end.
std::vector<std::size_t> places_in_plain(std::string_view text, std::size_t begin, std::string_view value);
std::size_t end_of_plain(std::string_view text, std::size_t begin, std::string_view value);

/// A block scalar, `|` or `>`.
struct Block {
  std::size_t body = 0; ///< where the first line behind the header begins
  std::size_t end = 0;  ///< behind the last byte that is not blank: of the header if the block is empty
};
/// `least`: how far its lines are indented at least, which is one more than the block list or mapping around it.
Block block_scalar(std::string_view text, std::size_t begin, std::size_t least);

} // namespace director::dsl::yaml_scan
