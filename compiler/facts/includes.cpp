// Header: compiler/facts/includes.hpp. Test: tests/compiler/facts/flags_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/facts/includes.hpp"

#include "dsl/lexical/characters.hpp"
#include "dsl/source/load_file.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>

namespace director::compiler {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view blanks = " \t\f\v";

/// The text without backslashes at the ends of lines, which continue in the next one.
std::string spliced(std::string_view text) {
  std::string out;
  while (true) {
    const std::size_t slash = text.find('\\');
    out += text.substr(0, slash);
    if (slash == std::string_view::npos) return out;
    text.remove_prefix(slash + 1);
    const std::size_t end = std::min(text.find_first_not_of(blanks), text.size()); // blanks there are ignored too
    const std::string_view rest = text.substr(end);
    const std::size_t line_end = rest.starts_with("\r\n")                           ? 2
                                 : rest.starts_with('\n') || rest.starts_with('\r') ? 1
                                                                                    : 0;
    if (line_end == 0) {
      out += '\\';
    } else {
      text.remove_prefix(end + line_end);
    }
  }
}

/// Whether a `#` there begins a directive: it is the first in its line, or behind a comment.
bool begins_directive(std::string_view before) {
  const std::size_t last = before.find_last_not_of(blanks);
  before = before.substr(0, last == std::string_view::npos ? 0 : last + 1);
  return before.empty() || before.ends_with('\n') || before.ends_with('\r') || before.ends_with("*/") ||
         before == dsl::byte_order_mark;
}

std::string_view without_blanks(std::string_view text) {
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    if (!text.starts_with("/*")) return text;
    const std::size_t end = text.find("*/", 2);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
  }
}

/// What follows `include` or `import`, if the text behind a `#` begins so.
std::optional<std::string_view> behind_include(std::string_view text) {
  text = without_blanks(text);
  for (const std::string_view word : {"include_next", "include", "import"}) {
    if (text.starts_with(word)) return without_blanks(text.substr(word.size()));
  }
  return {};
}

} // namespace

const Includes::File& Includes::file(const std::string& path) {
  const auto at = known_.find(path);
  if (at != known_.end()) return at->second;
  File out;
  if (const auto read = files_.read(path, dsl::largest_file, dsl::Kinds::ordinary)) {
    out.exists = true;
    const std::string text = spliced(read.value());
    for (std::size_t sign = text.find('#'); sign != std::string::npos; sign = text.find('#', sign + 1)) {
      const auto rest = behind_include(std::string_view(text).substr(sign + 1));
      if (!rest || !begins_directive(std::string_view(text).substr(0, sign))) continue;
      const std::string_view line = rest->substr(0, rest->find_first_of("\r\n"));
      const bool quoted = line.starts_with('"');
      const std::size_t close =
          quoted || line.starts_with('<') ? line.find(quoted ? '"' : '>', 1) : std::string_view::npos;
      out.lines.push_back(
          {close == std::string_view::npos ? std::string{} : std::string(line.substr(1, close - 1)), quoted});
    }
  }
  return known_.emplace(path, std::move(out)).first->second;
}

/// The file that the line includes; empty: there is none.
std::string Includes::find(const std::string& from, const std::vector<std::string>& folders, const Line& line) {
  if (line.quoted) {
    std::string beside = (fs::path(from).parent_path() / line.name).lexically_normal().string();
    if (file(beside).exists) return beside;
  }
  for (const std::string& folder : folders) {
    std::string there = (fs::path(folder) / line.name).lexically_normal().string();
    if (file(there).exists) return there;
  }
  return {};
}

bool Includes::search(const std::string& path, const std::vector<std::string>& folders, const Accept& accept) {
  std::vector<std::string> open{path};
  std::set<std::string> seen{path};
  while (!open.empty()) {
    const std::string from = std::move(open.back());
    open.pop_back();
    for (const Line& line : file(from).lines) {
      std::string found = line.name.empty() ? std::string{} : find(from, folders, line);
      if (found.empty() && !line.name.empty()) continue;
      if (accept(found)) return true;
      if (!found.empty() && seen.insert(found).second) open.push_back(std::move(found));
    }
  }
  return false;
}

bool Includes::may_include(const std::string& path, const std::vector<std::string>& folders,
                           const std::string& header) {
  const std::string wanted = fs::path(header).lexically_normal().string();
  return path == wanted ||
         search(path, folders, [&](const std::string& found) { return found.empty() || found == wanted; });
}

std::string Includes::find_named(const std::string& path, const std::vector<std::string>& folders,
                                 const std::string& name, const Accept& accept) {
  std::string out;
  search(path, folders, [&](const std::string& found) {
    if (fs::path(found).filename() != name || !accept(found)) return false;
    out = found;
    return true;
  });
  return out;
}

} // namespace director::compiler
