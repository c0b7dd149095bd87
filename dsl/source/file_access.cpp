// Header: dsl/source/file_access.hpp. Test: tests/dsl/source/file_access_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/source/file_access.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <deque>
#include <filesystem>
#include <system_error>
#include <utility>

namespace director::dsl {

namespace fs = std::filesystem;

namespace {

/// A wait below this is not reported.
constexpr std::chrono::milliseconds a_moment{300};

bool is_pipe(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && (S_ISFIFO(status.st_mode) || S_ISSOCK(status.st_mode));
}

struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) close(number);
  }
};

} // namespace

Result<std::string, FileError> DiskFiles::fetch(const std::string& path, std::size_t most, Kinds kinds) {
  const auto error = [](int number) {
    using Kind = FileError::Kind;
    const bool is_lost = number == ENOENT || number == ENOTDIR;
    return FileError{is_lost            ? Kind::not_found
                     : number == EISDIR ? Kind::folder
                                        : Kind::not_readable,
                     std::generic_category().message(number)};
  };
  // The system would read the path only up to the NUL, and open another file than the named one.
  if (path.find('\0') != path.npos) return error(ENOENT);
  const bool waits = kinds == Kinds::any;
  if (!waits && is_pipe(path)) return FileError{FileError::Kind::pipe, "it is a pipe, and no ordinary file"};
  // A pipe is opened without waiting for a writer: there may never be one.
  const Descriptor file{open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)};
  if (file.number < 0) return error(errno);
  struct stat about {};
  if (fstat(file.number, &about) == 0 && S_ISREG(about.st_mode) && about.st_size > 0 &&
      static_cast<std::size_t>(about.st_size) > most)
    return FileError{FileError::Kind::too_large, "file too large"};
  // Read to its end: only a regular file has a size, and that may change.
  std::string text;
  std::array<char, 1 << 16> part{};
  const std::chrono::milliseconds patience = waits ? patience_ : std::chrono::milliseconds(0);
  bool is_told = !waiting_;
  const auto comes_within = [&](std::chrono::milliseconds time) {
    pollfd waiting{file.number, POLLIN, 0};
    return poll(&waiting, 1, static_cast<int>(time.count())) != 0;
  };
  while (true) {
    const std::chrono::milliseconds first = is_told ? patience : std::min(a_moment, patience);
    bool comes = comes_within(first);
    if (!comes && first < patience) {
      is_told = true;
      waiting_(path, patience - first);
      comes = comes_within(patience - first);
    }
    if (!comes) return FileError{FileError::Kind::not_readable, "nothing writes to this pipe"};
    const ssize_t size = ::read(file.number, part.data(), part.size());
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (size < 0) return error(errno);
    if (size == 0) return text;
    text.append(part.data(), static_cast<std::size_t>(size));
    if (text.size() > most) return FileError{FileError::Kind::too_large, "file too large"};
  }
}

std::string FileAccess::beside(const std::string& file, const std::string& relative) {
  return (fs::path(file).parent_path() / relative).lexically_normal().string();
}

/// `lib/..` is the folder around the one to which the link `lib` leads: a link before `..` is replaced by its target.
std::string DiskFiles::beside(const std::string& file, const std::string& relative) {
  constexpr int most_links = 40; // as Linux; the system then says that there are too many
  const fs::path all = fs::path(file).parent_path() / relative;
  std::deque<fs::path> rest(all.begin(), all.end());
  fs::path out;
  for (int links = 0; !rest.empty();) {
    const fs::path part = std::move(rest.front());
    rest.pop_front();
    std::error_code failed;
    const bool is_named = part == ".." && out.has_filename() && out.filename() != "..";
    if (is_named && links < most_links && fs::is_symlink(out, failed)) {
      ++links;
      const fs::path target = fs::read_symlink(out, failed);
      rest.push_front(part);
      rest.insert(rest.begin(), target.begin(), target.end());
      out = out.parent_path();
    } else if (is_named) {
      out = out.parent_path();
    } else if (part != "." && !(part == ".." && out.has_root_directory() && !out.has_filename())) {
      out /= part;
    }
  }
  return out.empty() && !all.empty() ? "." : out.string();
}

std::string DiskFiles::identity(const std::string& path) {
  std::error_code failed;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, failed);
  return failed ? std::filesystem::path(path).lexically_normal().string() : canonical.string();
}

void MemoryFiles::add(const std::string& path, std::string text) { files_[identity(path)] = std::move(text); }

Result<std::string, FileError> MemoryFiles::fetch(const std::string& path, std::size_t most, Kinds) {
  const auto file = files_.find(identity(path));
  if (file == files_.end()) return FileError{FileError::Kind::not_found, "No such file or directory"};
  if (file->second.size() > most) return FileError{FileError::Kind::too_large, "file too large"};
  return file->second;
}

std::string MemoryFiles::identity(const std::string& path) {
  return std::filesystem::path(path).lexically_normal().string();
}

} // namespace director::dsl
