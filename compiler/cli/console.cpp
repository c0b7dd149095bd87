// Door: compiler/cli/console.hpp. Test: tests/cli/disk_test.cpp.
#include "compiler/cli/console.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace director::compiler::cli {

namespace fs = std::filesystem;

namespace {

std::optional<std::string> text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  return std::string{std::istreambuf_iterator<char>(file), {}};
}

} // namespace

std::optional<std::string> DiskOutputs::write(const std::string& path, const std::string& text) {
  if (text_of(path) == text) return {};
  return renew(path, text);
}

std::optional<std::string> DiskOutputs::renew(const std::string& path, const std::string& text) {
  std::error_code error;
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) return error.message();
  errno = 0;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) return errno != 0 ? std::strerror(errno) : "it cannot be written";
  return {};
}

std::optional<std::string> DiskOutputs::change(const std::vector<Change>& changes) { return apply_on_disk(changes); }

std::vector<std::string> DiskOutputs::list(const std::string& folder) {
  std::vector<std::string> out;
  std::error_code error;
  const auto deny = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(folder, deny, error), end; !error && at != end; at.increment(error)) {
    const bool hidden = at->path().filename().string().starts_with('.');
    std::error_code unknown;
    if (at->is_directory(unknown)) {
      if (hidden || fs::exists(at->path() / "CMakeCache.txt", unknown)) at.disable_recursion_pending();
    } else if (!hidden && at->is_regular_file(unknown)) {
      out.push_back(at->path().string());
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::optional<std::string> MemoryOutputs::write(const std::string& path, const std::string& text) {
  const auto at = files.find(path);
  if (at != files.end() && at->second == text) return {};
  return renew(path, text);
}

std::optional<std::string> MemoryOutputs::renew(const std::string& path, const std::string& text) {
  files[path] = text;
  written.push_back(path);
  return {};
}

std::optional<std::string> MemoryOutputs::change(const std::vector<Change>& changes) {
  for (const Change& each : changes) {
    const auto at = files.find(each.path);
    const std::optional<std::string> now = at == files.end() ? std::nullopt : std::optional(at->second);
    if (now != each.before) return "`" + each.path + "`: it has changed meanwhile; run this again";
  }
  for (const Change& each : changes) renew(each.path, each.after);
  return {};
}

std::vector<std::string> MemoryOutputs::list(const std::string& folder) {
  std::vector<std::string> out;
  for (const auto& [path, text] : files)
    if (path.starts_with(folder + "/")) out.push_back(path);
  return out;
}

} // namespace director::compiler::cli
