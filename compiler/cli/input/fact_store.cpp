// Header: compiler/cli/input/fact_store.hpp. Test: tests/compiler/cli/system/console_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/input/fact_store.hpp"

#include "compiler/cli/system/change.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <tuple>

namespace director::compiler::cli {

namespace fs = std::filesystem;

std::optional<std::string> DiskFacts::load(const std::string& name) {
  std::ifstream file(fs::path(folder_) / name, std::ios::binary);
  if (!file) return {};
  return std::string{std::istreambuf_iterator<char>(file), {}};
}

/// A concurrent run sees the old entry or the new one, never half of one.
void DiskFacts::save(const std::string& name, const std::string& text) {
  // A failure is ignored: the facts are computed again the next time.
  std::ignore = write_on_disk({{(fs::path(folder_) / name).string(), text}});
}

std::string DiskFacts::stamp(const std::string& path) {
  std::error_code fault;
  if (fs::is_directory(path, fault)) return "folder";
  const auto size = fs::file_size(path, fault);
  if (fault) return {};
  const auto time = fs::last_write_time(path, fault);
  return std::to_string(size) + ":" + std::to_string(time.time_since_epoch().count());
}

std::string facts_folder(const std::string& build) {
  if (!build.empty()) return (fs::path(build) / ".director").string();
  const char* const cache = std::getenv("XDG_CACHE_HOME");
  if (cache != nullptr && *cache != '\0') return (fs::path(cache) / "director").string();
  const char* const home = std::getenv("HOME");
  return (fs::path(home != nullptr ? home : "/tmp") / ".cache/director").string();
}

} // namespace director::compiler::cli
