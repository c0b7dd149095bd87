// Door: compiler/cli/change.hpp. Test: tests/stubs/change_test.cpp.
#include "compiler/cli/change.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

namespace director::compiler::cli {

namespace {

namespace fs = std::filesystem;
using Fault = std::optional<std::string>;

std::string at(const std::string& path, const std::string& why) { return "`" + path + "`: " + why; }

std::optional<std::string> text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  return std::string{std::istreambuf_iterator<char>(file), {}};
}

/// A file that is written already, beside the place that it is for. Removed unless it gets there.
struct Written {
  const Change* change;
  fs::path target; ///< behind symbolic links
  std::string temporary;
  mode_t mode = 0;
  bool placed = false;
};

/// May this file be changed, and is it still as it was?
Fault refusal(const Change& change, const fs::path& target, struct stat& status) {
  const bool exists = ::lstat(target.c_str(), &status) == 0;
  if (!change.before) return exists ? Fault{"it exists already"} : Fault{};
  if (!exists) return std::strerror(errno);
  if (!S_ISREG(status.st_mode)) return "it is no ordinary file";
  if ((status.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0 || ::access(target.c_str(), W_OK) != 0)
    return "it is read-only";
  if (text_of(target) != change.before) return "it has changed meanwhile; run this again";
  return {};
}

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(file, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return ::fsync(file) == 0 || errno == EINVAL || errno == EROFS; // not every file system can be told to
}

Fault write_beside(Written& out, std::string_view text) {
  std::string name = (out.target.parent_path() / ("." + out.target.filename().string() + ".XXXXXX")).string();
  const int file = ::mkstemp(name.data());
  if (file < 0) return std::strerror(errno);
  out.temporary = name;
  int fault = write_all(file, text) ? 0 : errno;
  if (fault == 0 && ::fchmod(file, out.mode) != 0) fault = errno;
  if (::close(file) != 0 && fault == 0) fault = errno;
  return fault == 0 ? Fault{} : std::strerror(fault);
}

/// Who made this file anew keeps its owner, if that is allowed.
void keep_owner(const Written& out, const struct stat& status) {
  if (out.change->before) std::ignore = ::lchown(out.temporary.c_str(), status.st_uid, status.st_gid);
}

mode_t mode_of_new_files() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

Fault prepare(const Change& change, std::vector<Written>& all) {
  std::error_code error;
  fs::path target = change.path;
  if (change.before) target = fs::canonical(target, error);
  if (error) return error.message();
  struct stat status {};
  if (Fault fault = refusal(change, target, status)) return fault;
  if (!change.before && target.has_parent_path()) fs::create_directories(target.parent_path(), error);
  if (error) return error.message();
  all.push_back({&change, target, {}, change.before ? status.st_mode & 07777U : mode_of_new_files(), false});
  Fault fault = write_beside(all.back(), change.after);
  if (!fault) keep_owner(all.back(), status);
  return fault;
}

/// A new file never takes the place of one.
Fault place(Written& each) {
  struct stat status {};
  if (Fault fault = refusal(*each.change, each.target, status)) return fault;
  const unsigned only_new = each.change->before ? 0 : RENAME_NOREPLACE;
  if (::renameat2(AT_FDCWD, each.temporary.c_str(), AT_FDCWD, each.target.c_str(), only_new) != 0) {
    // Not every file system knows that word; a link never takes the place of a file either.
    if (only_new == 0 || (errno != EINVAL && errno != ENOSYS)) return std::strerror(errno);
    if (::link(each.temporary.c_str(), each.target.c_str()) != 0) return std::strerror(errno);
    ::unlink(each.temporary.c_str());
  }
  each.placed = true;
  return {};
}

void take_back(std::vector<Written>& all) {
  for (Written& each : all) {
    if (!each.placed) {
      if (!each.temporary.empty()) ::unlink(each.temporary.c_str());
    } else if (!each.change->before) {
      ::unlink(each.target.c_str());
    } else if (!write_beside(each, *each.change->before)) {
      ::rename(each.temporary.c_str(), each.target.c_str());
    }
  }
}

} // namespace

std::optional<std::string> apply_on_disk(const std::vector<Change>& changes) {
  std::vector<Written> all;
  all.reserve(changes.size());
  Fault fault;
  const Change* last = nullptr;
  for (const Change& change : changes) {
    last = &change;
    if (fault = prepare(change, all); fault) break;
  }
  for (std::size_t i = 0; !fault && i < all.size(); ++i) {
    last = all[i].change;
    fault = place(all[i]);
  }
  if (!fault) return {};
  take_back(all);
  return at(last->path, *fault);
}

} // namespace director::compiler::cli
