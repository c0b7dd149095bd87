// Header: dsl/yaml/yaml_scan.hpp. Test: tests/dsl/yaml/yaml_scan_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/yaml/yaml_scan.hpp"

#include "dsl/lexical/characters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace director::dsl::yaml_scan {

namespace {

std::size_t line_begin(std::string_view text, std::size_t at) {
  const std::size_t newline = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  return newline == std::string_view::npos ? 0 : newline + 1;
}

std::size_t line_end(std::string_view text, std::size_t at) { return std::min(text.find('\n', at), text.size()); }

} // namespace

std::optional<Fault> forbidden_bytes(std::string_view text) {
  using namespace std::string_view_literals;
  const std::string save_as = "save the file as UTF-8 without a byte order mark";
  if (text.starts_with(byte_order_mark))
    return Fault{0, byte_order_mark.size(), "the file begins with a byte order mark", save_as};
  if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv) ||
      (text.size() > 3 && (text.starts_with("\0\0\0"sv) || text.substr(1, 3) == "\0\0\0"sv)))
    return Fault{0, 4, "the file is UTF-32, expected UTF-8", save_as};
  const bool has_mark = text.starts_with("\xFF\xFE"sv) || text.starts_with("\xFE\xFF"sv);
  if (has_mark || (text.size() > 1 && (text[0] == '\0') != (text[1] == '\0')))
    return Fault{0, 2, "the file is UTF-16, expected UTF-8", save_as};
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = static_cast<std::uint8_t>(text[at]);
    const bool line_break = byte == '\n' || (byte == '\r' && at + 1 < text.size() && text[at + 1] == '\n');
    if ((byte < 0x20 && byte != '\t' && !line_break) || byte == 0x7F)
      return Fault{at, at + 1, fmt::format("the byte 0x{:02X} may not stand in a text", byte),
                   byte == '\r' ? "save the file with LF or CRLF at the ends of its lines" : "leave it out"};
    const std::size_t length = utf8_length(text, at);
    if (length == 0) return Fault{at, at + 1, fmt::format("the byte 0x{:02X} is not UTF-8", byte), save_as};
    at += length;
  }
  return std::nullopt;
}

std::optional<Fault> conflict_marker(std::string_view text) {
  constexpr std::size_t length = 7;
  for (std::size_t at = 0; at < text.size(); at = line_end(text, at) + 1) {
    const char first = text[at];
    if (first != '<' && first != '|' && first != '=' && first != '>') continue;
    const std::size_t end = std::min(text.find_first_not_of(first, at), text.size());
    if (end - at != length || (end < text.size() && !is_space(text[end]))) continue;
    return Fault{at, end, "a merge conflict is not resolved",
                 "keep one side, and leave out the lines that begin with `<<<<<<<`, `|||||||`, `=======` or `>>>>>>>`"};
  }
  return std::nullopt;
}

std::optional<std::size_t> tab_in_indentation(std::string_view text, std::size_t at) {
  const std::size_t begin = line_begin(text, at);
  const std::size_t first = text.find_first_not_of(" \t", begin);
  if (first == std::string_view::npos || text[first] == '#' || text[first] == '\n' || text[first] == '\r') return {};
  const std::size_t tab = text.find('\t', begin);
  return tab < first ? std::optional(tab) : std::nullopt;
}

std::optional<std::size_t> end_of_quoted(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  for (std::size_t at = begin + 1; at < text.size(); ++at) {
    if (quote == '"' && text[at] == '\\') {
      ++at;
    } else if (text[at] == quote) {
      if (quote == '"' || at + 1 == text.size() || text[at + 1] != quote) return at + 1;
      ++at; // '' inside single quotes is one quote
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> unclosed_quote(std::string_view text, std::size_t from) {
  for (std::size_t at = from; at < text.size(); ++at) {
    const bool opens =
        at == 0 || is_space(text[at - 1]) || std::string_view("[{,:").find(text[at - 1]) != std::string_view::npos;
    if (!opens) continue;
    if (text[at] == '#') {
      at = line_end(text, at);
    } else if (text[at] == '"' || text[at] == '\'') {
      const auto end = end_of_quoted(text, at);
      if (!end) return at;
      at = *end - 1;
    }
  }
  return std::nullopt;
}

namespace {

/// The content of a line, as a part of the text: without indentation, the dashes of lists, and what is behind the text.
std::string_view content_of(std::string_view line) {
  while (!line.empty() && (is_space(line.front()) || line.starts_with("- "))) line.remove_prefix(1);
  for (std::size_t at = 0; at < line.size(); ++at)
    if (line[at] == '#' && (at == 0 || is_space(line[at - 1]))) line = line.substr(0, at);
  while (!line.empty() && is_space(line.back())) line.remove_suffix(1);
  return line;
}

bool has_key(std::string_view content) {
  return content.ends_with(':') || content.find(": ") != std::string_view::npos;
}

/// Whether it may be the rest of a key and its value: a word first, and closed brackets.
bool may_be_bare_key(std::string_view content) {
  if (content.empty() || std::string_view("[]{},\"'|>#&*!%@`?-").find(content.front()) != std::string_view::npos)
    return false;
  int depth = 0;
  for (const char c : content) {
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && --depth < 0) return false;
  }
  return depth == 0 && !has_key(content);
}

/// The word before the bracket at `at`, with its colon if that stands directly before the bracket.
std::optional<BareKey> word_before(std::string_view text, std::size_t at) {
  const bool colon = at > 0 && text[at - 1] == ':';
  std::size_t end = colon ? at - 1 : at;
  while (!colon && end > 0 && is_space(text[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && is_word(text[begin - 1])) --begin;
  if (begin == end) return {};
  return BareKey{begin, end + (colon ? 1 : 0), colon};
}

} // namespace

std::optional<BareKey> bare_key_above(std::string_view text, std::size_t at) {
  std::size_t line = line_begin(text, std::min(at, text.size()));
  if (has_key(text.substr(line, std::min(at, text.size()) - line))) return {}; // the second colon of its own line
  std::optional<BareKey> out;
  while (line > 0) {
    const std::size_t end = line - 1;
    line = line_begin(text, end);
    const std::string_view whole = text.substr(line, end - line);
    const std::string_view content = content_of(whole);
    if (content.empty() && content_of(whole.substr(0, whole.find('#'))).empty()) continue; // blank, or a comment
    if (!may_be_bare_key(content)) break;
    const auto begin = static_cast<std::size_t>(content.data() - text.data());
    const std::size_t size = std::min(content.find_first_of(" \t[{:"), content.size());
    const bool colon = size < content.size() && content[size] == ':';
    out = BareKey{begin, begin + size + (colon ? 1 : 0), colon};
    if (content.data() != whole.data() + std::min(whole.find_first_not_of(" \t"), whole.size())) break; // behind a dash
  }
  return out;
}

std::optional<BareKey> bare_key_before(std::string_view text, std::size_t at) {
  if (at >= text.size() || (text[at] != '[' && text[at] != '{')) return {};
  const auto key = word_before(text, at);
  if (!key) return {};
  std::size_t before = key->begin;
  while (before > 0 && is_space(text[before - 1])) --before;
  if (before == 0 || (text[before - 1] != '{' && text[before - 1] != ',')) return {};
  return key;
}

std::optional<BareKey> bare_key_with_bracket(std::string_view text, std::size_t at) {
  int depth = 0; // of the brackets that are closed behind
  for (std::size_t place = std::min(at, text.size()); place > 0 && text[place - 1] != '\n'; --place) {
    const char c = text[place - 1];
    if (c == '"' || c == '\'' || c == '#') return {};
    if (c == ']' || c == '}') ++depth;
    if ((c == '[' || c == '{') && --depth < 0) return word_before(text, place - 1);
  }
  return {};
}

std::optional<BareKey> bare_key_in(std::string_view text, std::size_t begin, std::size_t end) {
  const std::size_t colon = text.find(':', begin);
  if (colon >= end || colon + 1 >= end || text[colon + 1] == ':' || text[colon + 1] == '/') return {};
  const std::string_view word = text.substr(begin, colon - begin);
  if (word.empty() || !std::all_of(word.begin(), word.end(), is_word)) return {};
  return BareKey{begin, colon + 1, true};
}

std::optional<BareKey> too_long_key(std::string_view text, std::size_t from, std::size_t at) {
  std::size_t begin = std::min(from, text.size());
  if (at < text.size() && text[at] == ':') { // behind a key in a line of its own
    begin = text.find_last_of('\n', at) + 1;
    begin = std::min(text.find_first_not_of(" -", begin), at);
  } else if (begin < text.size() && text[begin] == ',') { // which ended the pair before
    begin = skip_blanks(text, begin + 1);
  }
  const std::size_t end = std::min(text.find_first_of(":,[]{}#\n", begin), text.size());
  if (end == text.size() || text[end] != ':' || end - begin <= longest_key) return std::nullopt;
  return BareKey{begin, end};
}

bool begins_line_before(std::string_view text, std::size_t first, std::size_t second) {
  const auto column = [&](std::size_t at) { return at - line_begin(text, at); };
  const auto is_first = [&](std::size_t at) {
    return text.substr(line_begin(text, at), column(at)).find_first_not_of(" \t") == std::string_view::npos;
  };
  return is_first(first) && is_first(second) && column(first) <= column(second);
}

std::size_t skip_blanks(std::string_view text, std::size_t at) {
  for (; at < text.size(); ++at) {
    if (text[at] == '#' && (at == 0 || is_space(text[at - 1]))) {
      at = line_end(text, at);
      if (at == text.size()) break;
    } else if (!is_space(text[at])) {
      break;
    }
  }
  return at;
}

namespace {

/// Calls `report` for each byte of the value with its place; returns the end.
template <class Report>
std::size_t walk_plain(std::string_view text, std::size_t begin, std::string_view value, const Report& report) {
  std::size_t at = begin;
  std::size_t end = begin; // behind the last byte that was found
  for (const char c : value) {
    // A line break in the text, with the blanks around it, is one blank or several line breaks in the value.
    if (at < text.size() && text[at] != c && is_space(text[at]))
      while (at < text.size() && text[at] != c && is_space(text[at])) ++at;
    const bool found = at < text.size() && text[at] == c;
    report(found ? at : end);
    if (found) end = ++at;
  }
  return end;
}

} // namespace

std::vector<std::size_t> places_in_plain(std::string_view text, std::size_t begin, std::string_view value) {
  std::vector<std::size_t> out;
  out.reserve(value.size() + 1);
  out.push_back(walk_plain(text, begin, value, [&](std::size_t place) { out.push_back(place); }));
  return out;
}

std::size_t end_of_plain(std::string_view text, std::size_t begin, std::string_view value) {
  return walk_plain(text, begin, value, [](std::size_t) {});
}

Block block_scalar(std::string_view text, std::size_t begin, std::size_t least) {
  const std::size_t header_end = line_end(text, begin);
  std::optional<std::size_t> indent;
  for (std::size_t at = begin + 1; at < header_end && !is_space(text[at]); ++at)
    if (text[at] >= '1' && text[at] <= '9')
      indent = (least == 0 ? 0 : least - 1) + static_cast<std::size_t>(text[at] - '0');
  std::size_t last = header_end; // behind the header while there is no content: comments count as the header's
  while (last > begin && is_space(text[last - 1])) --last;
  Block block{std::min(header_end + 1, text.size()), last};
  for (std::size_t line = block.body; line < text.size(); line = line_end(text, line) + 1) {
    const std::size_t end = line_end(text, line);
    std::size_t first = line;
    while (first < end && text[first] == ' ') ++first;
    std::size_t back = end;
    while (back > first && is_space(text[back - 1])) --back;
    if (back == first) continue; // a blank line belongs to the block if another one follows
    if (!indent) indent = std::max(first - line, least);
    if (first - line < *indent || text.substr(line, 3) == "...") break;
    block.end = back;
  }
  return block;
}

} // namespace director::dsl::yaml_scan
