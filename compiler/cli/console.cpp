// Door: compiler/cli/console.hpp. Test: tests/cli/disk_test.cpp.
#include "compiler/cli/console.hpp"

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

} // namespace director::compiler::cli
