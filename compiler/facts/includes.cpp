// Header: compiler/facts/includes.hpp. Test: tests/compiler/facts/flags_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/facts/includes.hpp"

#include "dsl/source/load_file.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>

namespace director::compiler {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view blanks = " \t";

std::string_view without_blanks(std::string_view text) {
  const std::size_t at = text.find_first_not_of(blanks);
  return at == std::string_view::npos ? std::string_view{} : text.substr(at);
}

} // namespace

const Includes::File& Includes::file(const std::string& path) {
  const auto at = known_.find(path);
  if (at != known_.end()) return at->second;
  File out;
  if (const auto text = files_.read(path, dsl::largest_file, dsl::Kinds::ordinary)) {
    out.exists = true;
    std::string_view rest = text.value();
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      std::string_view line = without_blanks(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
      if (!line.starts_with('#')) continue;
      line = without_blanks(line.substr(1));
      if (!line.starts_with("include")) continue;
      line = without_blanks(line.substr(line.starts_with("include_next") ? 12 : 7));
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
