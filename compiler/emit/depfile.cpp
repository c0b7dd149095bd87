// Header: compiler/emit/depfile.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/depfile.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

namespace {

/// As compilers write it, for Make and Ninja: a backslash is doubled only before a blank.
std::string escaped_path(const std::string& path) {
  std::string out;
  std::size_t backslashes = 0; // directly before this letter
  for (const char letter : path) {
    if (letter == ' ') out.append(backslashes, '\\');
    if (letter == ' ' || letter == '#' || letter == ':') out += '\\';
    if (letter == '$') out += '$';
    out += letter;
    backslashes = letter == '\\' ? backslashes + 1 : 0;
  }
  return out;
}

bool is_expressible(const std::string& path) { return path.find_first_of(";|\t\n") == std::string::npos; }

} // namespace

std::optional<std::string> inexpressible_path(const std::vector<std::string>& outputs, const dsl::Sources& sources,
                                              const std::vector<std::string>& others) {
  std::vector<std::string> paths = outputs;
  for (const dsl::SourceFile& file : sources) paths.push_back(file.path());
  paths.insert(paths.end(), others.begin(), others.end());
  const auto wrong = std::find_if_not(paths.begin(), paths.end(), is_expressible);
  return wrong == paths.end() ? std::nullopt : std::optional(*wrong);
}

std::string no_depfile(const std::string& path, const std::string& depfile, const std::string& result) {
  return fmt::format("directorc: a depfile for Make and Ninja cannot name `{}`, because of its `;`, `|`, tab or line "
                     "break: {}; rename the file, or leave out `--depfile {}`\n",
                     path, result, depfile);
}

std::string depfile(const std::vector<std::string>& outputs, const dsl::Sources& sources,
                    const std::vector<std::string>& others) {
  std::string out;
  for (const std::string& path : outputs) out += (out.empty() ? "" : " ") + escaped_path(path);
  out += ":";
  for (const dsl::SourceFile& file : sources) out += " \\\n  " + escaped_path(file.path());
  for (const std::string& path : others) out += " \\\n  " + escaped_path(path);
  out += "\n";
  return out;
}

} // namespace director::compiler
