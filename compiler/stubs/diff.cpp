// Header: compiler/stubs/insertion.hpp. Test: tests/compiler/stubs/diff_test.cpp.
// SPDX-License-Identifier: MIT
//
// The insertions are known, so no lines need to be compared: a line with text inserted into it is removed and added
// again as several; a line with text inserted after it remains.
#include "compiler/base/hunks.hpp"
#include "compiler/stubs/insertion.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler::stubs {

namespace {

/// With their line breaks; the last one may have none.
std::vector<std::string_view> lines_with_breaks(std::string_view text) {
  std::vector<std::string_view> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    out.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return out;
}

struct Edit {
  char sign; ///< ' ', '-' or '+'
  std::string line;
};

/// Replaces one line: its beginning and end remain if they are whole lines again.
void edit_line(std::vector<Edit>& edits, std::string_view old, std::string_view fresh) {
  const std::vector<std::string_view> lines = lines_with_breaks(fresh);
  const bool first = lines.front() == old;
  const bool last = !first && lines.back() == old;
  if (!first && !last) edits.push_back({'-', std::string(old)});
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool stays = (first && i == 0) || (last && i + 1 == lines.size());
    edits.push_back({stays ? ' ' : '+', std::string(lines[i])});
  }
}

std::vector<Edit> edits_of(std::string_view text, const std::vector<Insertion>& insertions) {
  std::vector<Edit> out;
  std::size_t begin = 0, next = 0;
  const auto edit = [&](std::string_view line, bool is_last) {
    const std::size_t end = begin + line.size();
    std::string fresh;
    std::size_t done = begin;
    for (; next < insertions.size() && (insertions[next].offset < end || is_last); ++next) {
      fresh += text.substr(done, insertions[next].offset - done);
      fresh += insertions[next].text;
      done = insertions[next].offset;
    }
    fresh += text.substr(done, end - done);
    if (fresh.empty()) return;
    if (fresh == line) {
      out.push_back({' ', fresh});
    } else if (line.empty()) {
      for (const std::string_view added : lines_with_breaks(fresh)) out.push_back({'+', std::string(added)});
    } else {
      edit_line(out, line, fresh);
    }
    begin = end;
  };
  const std::vector<std::string_view> lines = lines_with_breaks(text);
  const bool ends = text.empty() || text.ends_with('\n'); // then the text behind the last line has a line break of its
                                                          // own
  for (std::size_t i = 0; i < lines.size(); ++i) edit(lines[i], !ends && i + 1 == lines.size());
  if (ends) edit({}, true);
  return out;
}

/// The lines of the hunks, each with its line break.
std::string text_of_hunks(const std::vector<Edit>& edits) {
  const std::string unended = "\n\\ No newline at end of file";
  std::vector<std::string> lines;
  for (const Edit& edit : edits)
    lines.push_back(edit.line.ends_with('\n') ? edit.line.substr(0, edit.line.size() - 1) : edit.line + unended);
  std::vector<DiffLine> all;
  for (std::size_t i = 0; i < edits.size(); ++i) all.push_back({edits[i].sign, lines[i]});
  std::string out;
  for (const std::string& line : hunks(all)) out.append(line).push_back('\n');
  return out;
}

std::string_view path_in_diff(std::string_view path) { return path.substr(path.starts_with('/') ? 1 : 0); }

} // namespace

std::string diff(const std::string& path, std::string_view text, const std::vector<Insertion>& insertions) {
  const std::string_view name = path_in_diff(path);
  return fmt::format("--- a/{0}\n+++ b/{0}\n{1}", name, text_of_hunks(edits_of(text, insertions)));
}

std::string diff_of_new(const std::string& path, std::string_view text) {
  return fmt::format("--- /dev/null\n+++ b/{}\n{}", path_in_diff(path),
                     text_of_hunks(edits_of({}, {{path, 0, std::string(text)}})));
}

} // namespace director::compiler::stubs
