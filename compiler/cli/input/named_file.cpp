// Header: compiler/cli/input/named_file.hpp. Test: tests/compiler/cli/input/named_file_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/input/named_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace director::compiler::cli {

namespace fs = std::filesystem;

bool is_called_scenario(std::string_view path) {
  return path.ends_with(".scenario.yaml") || path.ends_with(".scenario.yml");
}

bool is_called_behaviour(std::string_view path) {
  return (path.ends_with(".yaml") || path.ends_with(".yml")) && !is_called_scenario(path);
}

bool is_called_trace(std::string_view path) { return path.ends_with(".jsonl"); }

std::string file_instead(const std::string& path, bool (*is_wanted)(std::string_view), Console& console) {
  const auto read = console.files.read(path, 0, dsl::Kinds::ordinary);
  if (!read && path == "-")
    return "; the standard input is called `/dev/stdin`, and relative paths in it begin at `/dev`";
  if (read || read.error().kind != dsl::FileError::Kind::folder) return {};
  const fs::path folder = fs::path(path) / "";
  const std::string own = folder.parent_path().filename().string() + ".";
  std::string best;
  bool is_own = false;
  std::error_code error, unknown;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    const bool has_name = name.starts_with(own);
    if (!is_wanted(name) || name.starts_with('.') || !at->is_regular_file(unknown) || has_name < is_own) continue;
    if (has_name > is_own || best.empty() || name < best) best = name;
    is_own = has_name;
  }
  return best.empty() ? "; name a file" : fmt::format("; name a file in it, such as `{}`", (folder / best).string());
}

} // namespace director::compiler::cli
