// Door: dsl/file_access.hpp. Test: tests/dsl/file_access_test.cpp.
#include "dsl/file_access.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

namespace director::dsl {

Result<std::string, FileError> DiskFiles::read(const std::string& path, std::size_t most) {
  const auto error = [](int number) {
    return FileError{number == ENOENT || number == ENOTDIR ? FileError::Kind::not_found : FileError::Kind::not_readable,
                     std::generic_category().message(number)};
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) return error(errno);
  // Read and not asked for its size: what is no plain file has none.
  std::string text;
  std::array<char, 1 << 16> part{};
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), file.get())) {
    text.append(part.data(), size);
    if (text.size() > most) return FileError{FileError::Kind::too_large, "file too large"};
  }
  if (std::ferror(file.get())) return error(errno);
  return text;
}

std::string DiskFiles::identity(const std::string& path) {
  std::error_code failed;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, failed);
  return failed ? std::filesystem::path(path).lexically_normal().string() : canonical.string();
}

void MemoryFiles::add(const std::string& path, std::string text) { files_[identity(path)] = std::move(text); }

Result<std::string, FileError> MemoryFiles::read(const std::string& path, std::size_t most) {
  const auto file = files_.find(identity(path));
  if (file == files_.end()) return FileError{FileError::Kind::not_found, "No such file or directory"};
  if (file->second.size() > most) return FileError{FileError::Kind::too_large, "file too large"};
  return file->second;
}

std::string MemoryFiles::identity(const std::string& path) {
  return std::filesystem::path(path).lexically_normal().string();
}

} // namespace director::dsl
