// Header: compiler/reference/explain_key.hpp. Test: tests/compiler/reference/explain_key_test.cpp.
// SPDX-License-Identifier: MIT
//
// Parses the reference, which is Markdown. A table whose rows begin with a key in backticks, `needs` or `advance:
// 100 ms`, documents keys; a link in that cell leads to the section with the details.
#include "compiler/reference/explain_key.hpp"

#include "compiler/base/contains.hpp"
#include "dsl/lexical/characters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace director::compiler {

namespace {

struct Row {
  std::string head;                  ///< of the first column: `key of a group`
  std::vector<std::string> keys;     ///< the keys in its first cell
  std::vector<std::string> sections; ///< the headings to which it leads, as in a link: `tasks-and-packs`
  std::string text;                  ///< without its bars
};

/// A paragraph, an entry of a list, a block of code with its fences.
struct Piece {
  std::string text;
  bool code = false;
  std::set<std::string> words; ///< in backticks; of code its keys
};

struct Section {
  std::string title;
  std::string anchor; ///< as links have it
  std::vector<Row> rows;
  std::vector<Piece> pieces; ///< without comments; includes the rows
};

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

/// `[tasks](#needs)` is `tasks`.
std::string without_links(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t middle = text[at] == '[' ? text.find("](", at) : std::string_view::npos;
    const std::size_t inner = text[at] == '[' ? text.find('[', at + 1) : std::string_view::npos;
    const std::size_t end = middle == std::string_view::npos ? middle : text.find(')', middle);
    if (end == std::string_view::npos || inner < middle) {
      out += text[at++];
    } else {
      out += text.substr(at + 1, middle - at - 1);
      at = end + 1;
    }
  }
  return out;
}

std::vector<std::string> links_in(std::string_view text) {
  std::vector<std::string> out;
  for (std::size_t at = text.find("](#"); at != std::string_view::npos; at = text.find("](#", at + 1)) {
    const std::size_t end = text.find(')', at);
    if (end != std::string_view::npos) out.emplace_back(text.substr(at + 3, end - at - 3));
  }
  return out;
}

/// The first word of code in backticks: `advance: 100 ms` is `advance`, in a cell `broken Walk` is `broken`.
std::vector<std::string> codes_in(std::string_view text, bool in_cell = false) {
  std::vector<std::string> out;
  for (std::size_t at = text.find('`'); at != std::string_view::npos; at = text.find('`', at + 1)) {
    const std::size_t end = text.find('`', at + 1);
    if (end == std::string_view::npos) break;
    const std::string_view code = text.substr(at + 1, end - at - 1);
    std::size_t size = 0;
    while (size < code.size() && dsl::is_word(code[size])) ++size;
    if (size > 0 && (size == code.size() || code[size] == ':' || (in_cell && code[size] == ' ')))
      out.emplace_back(code.substr(0, size));
    at = end;
  }
  return out;
}

/// In YAML: each word with a colon behind it.
std::set<std::string> keys_in_code(std::string_view code) {
  std::set<std::string> out;
  for (std::size_t at = code.find(':'); at != std::string_view::npos; at = code.find(':', at + 1)) {
    std::size_t begin = at;
    while (begin > 0 && dsl::is_word(code[begin - 1])) --begin;
    if (begin < at) out.emplace(code.substr(begin, at - begin));
  }
  return out;
}

std::string anchor_of(std::string_view title) {
  std::string out;
  for (const char c : title) {
    if (dsl::is_word(c) || c == '-') out += dsl::lower(c);
    if (c == ' ') out += '-';
  }
  return out;
}

/// The cells of a line of a table, trimmed.
std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> out;
  bool code = false;
  std::size_t begin = 1;
  for (std::size_t at = 1; at < line.size(); ++at) {
    if (line[at] == '`') code = !code;
    if (line[at] != '|' || code) continue;
    out.push_back(dsl::trimmed(line.substr(begin, at - begin)));
    begin = at + 1;
  }
  return out;
}

class Page {
public:
  explicit Page(std::string_view text) {
    sections_.push_back({});
    for (const std::string_view line : lines_of(text)) read(line);
    flush();
  }
  std::vector<Section> take() { return std::move(sections_); }

private:
  void read(std::string_view line) {
    const bool in_table = std::exchange(in_table_, !code_ && line.starts_with("| "));
    if (comment_ || (!code_ && line.starts_with("<!--"))) { // the origin of a block, for the tests of the page
      flush();
      comment_ = line.find("-->") == std::string_view::npos;
    } else if (line.starts_with("```")) {
      if (!code_) flush();
      add(line);
      if (code_) flush(true);
      code_ = !code_;
    } else if (code_) {
      add(line);
    } else if (line.starts_with("# ") || line.starts_with("## ") || line.starts_with("### ")) {
      flush();
      const std::string_view title = line.substr(line.find(' ') + 1);
      std::string plain(title);
      std::erase(plain, '`');
      sections_.push_back({plain, anchor_of(title), {}, {}});
    } else if (line.empty()) {
      flush();
    } else if (line.starts_with("| ")) {
      if (in_table)
        row(line);
      else
        begin_table(line);
    } else {
      if (line.starts_with("- ")) flush();
      add(line);
    }
  }

  /// The first line of a table is its head.
  void begin_table(std::string_view line) {
    flush();
    const std::vector<std::string_view> cells = cells_of(line);
    head_ = cells.empty() ? std::string{} : without_links(cells.front());
    std::erase(head_, '`');
  }

  void row(std::string_view line) {
    const std::vector<std::string_view> cells = cells_of(line);
    if (cells.empty() || cells.front().starts_with("---")) return;
    std::vector<std::string> keys = codes_in(cells.front(), true);
    if (keys.empty()) return;
    std::string text = without_links(cells.front());
    for (std::size_t i = 1; i < cells.size(); ++i) text += (i == 1 ? ": " : "; ") + without_links(cells[i]);
    sections_.back().rows.push_back({head_, std::move(keys), links_in(cells.front()), text});
    add(fmt::format("- {}", text));
    flush();
  }

  void add(std::string_view line) {
    piece_ += line;
    piece_ += '\n';
  }

  void flush(bool code = false) {
    if (piece_.empty()) return;
    Piece piece{code ? piece_ : without_links(piece_), code, {}};
    if (code) {
      piece.words = keys_in_code(piece_);
    } else {
      for (std::string& word : codes_in(piece_)) piece.words.insert(std::move(word));
    }
    sections_.back().pieces.push_back(std::move(piece));
    piece_.clear();
  }

  std::vector<Section> sections_;
  std::string piece_, head_;
  bool code_ = false, comment_ = false, in_table_ = false;
};

/// Pieces, with a blank line between two unless both are entries of one list.
void write(std::string& out, const Piece& piece) {
  const bool entry = piece.text.starts_with("- ");
  const std::size_t line = out.rfind('\n', out.size() - 2);
  const bool behind_entry = line != std::string::npos && out.compare(line + 1, 2, "- ") == 0;
  if (!(entry && behind_entry)) out += '\n';
  out += piece.text;
}

} // namespace

std::string page_without_links(std::string_view page) {
  std::string out;
  bool code = false;
  for (const std::string_view line : lines_of(page)) {
    if (line.starts_with("```")) code = !code;
    out += code ? std::string(line) : without_links(line);
    out += '\n';
  }
  return out;
}

std::string reference() { return fmt::format("{}\n{}", language_page(), scenarios_page()); }

std::vector<std::string> keys_of(std::string_view page) {
  std::set<std::string> keys;
  for (const Section& section : Page(page).take())
    for (const Row& row : section.rows)
      for (const std::string& key : row.keys) keys.insert(key);
  return {keys.begin(), keys.end()};
}

std::optional<std::string> explain_key(std::string_view page, std::string_view key) {
  const std::string word(key);
  const std::vector<Section> sections = Page(page).take();
  std::string rows, out;
  std::set<std::string> leads; // anchors of sections that are printed whole
  bool known = false;
  const Section* home = nullptr; ///< with its first row
  for (const Section& section : sections) {
    for (const Row& row : section.rows) {
      if (!contains(row.keys, key)) continue;
      known = true;
      if (home == nullptr) home = &section;
      const std::string kind = row.head.starts_with("key") ? row.head : fmt::format("in the table \"{}\"", row.head);
      rows += fmt::format("- {} ({}, under \"{}\")\n", row.text, kind, section.title);
      leads.insert(row.sections.begin(), row.sections.end());
    }
    if (section.anchor == key) leads.insert(section.anchor);
  }
  bool example = false;
  std::string first; // its first example, in any section
  for (const Section& section : sections) {
    const bool whole = leads.contains(section.anchor);
    const bool own = leads.empty() && &section == home;
    std::string text;
    for (const Piece& piece : section.pieces) {
      const bool row = std::any_of(section.rows.begin(), section.rows.end(),
                                   [&](const Row& each) { return piece.text == "- " + each.text + "\n"; });
      const bool mentions = piece.words.contains(word);
      if (first.empty() && mentions && piece.text.starts_with("```yaml")) first = piece.text;
      if (!whole && (row || !mentions || (piece.code && (example || (text.empty() && !own))))) continue;
      if (piece.code && mentions) example = true;
      known = known || mentions;
      write(text, piece);
    }
    if (!text.empty()) out += fmt::format("\n## {}\n{}", section.title, text);
  }
  if (!known) return std::nullopt;
  if (!example && !first.empty()) out += "\n## An example\n\n" + first;
  return fmt::format("# {}\n{}{}{}", key, rows.empty() ? "" : "\n", rows, out);
}

} // namespace director::compiler
