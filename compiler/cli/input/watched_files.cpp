// Header: compiler/cli/input/watched_files.hpp. Test: tests/compiler/cli/input/watched_files_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/input/watched_files.hpp"

#include "compiler/cli/input/named_file.hpp"
#include "dsl/source/load_file.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <string_view>

namespace director::compiler::cli {

namespace {

std::int64_t nanoseconds(const timespec& time) { return time.tv_sec * std::int64_t{1'000'000'000} + time.tv_nsec; }

/// The coarsest resolution of timestamps of a file system in use, FAT's.
constexpr std::int64_t coarse = 2'000'000'000;

bool is_recent(const FileStamp& stamp) {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  return nanoseconds(now) - std::max(stamp.modified, stamp.changed) <= coarse;
}

std::size_t sum_of(const std::string& text) { return std::hash<std::string>{}(text); }

std::vector<std::string> scenarios_among(std::vector<std::string> paths) {
  std::erase_if(paths, [](const std::string& path) { return !is_called_scenario(path); });
  return paths;
}

template <class Seen>
std::vector<std::string> keys_of(const std::map<std::string, Seen>& seen) {
  std::vector<std::string> out;
  for (const auto& [path, what] : seen) out.push_back(path);
  return out;
}

} // namespace

FileStamp stamp_of(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return {};
  return {true, status.st_dev, status.st_ino, status.st_size, nanoseconds(status.st_mtim), nanoseconds(status.st_ctim)};
}

dsl::Result<std::string, dsl::FileError> WatchedFiles::fetch(const std::string& path, std::size_t most,
                                                             dsl::Kinds kinds) {
  // Before it is read: what is written meanwhile is a change.
  const FileStamp stamp = stamp_of(path);
  auto text = files_.read(path, most, kinds);
  // The first read of this run counts; a change since then is a change.
  Seen& seen = seen_.try_emplace(path, Seen{stamp, {}}).first->second;
  if (text && !seen.sum && stamp == seen.stamp && is_recent(stamp)) seen.sum = sum_of(text.value());
  return text;
}

std::vector<FileChange> WatchedFiles::changes() const {
  std::vector<FileChange> out;
  for (const auto& [path, seen] : seen_) {
    const FileStamp now = stamp_of(path);
    if (now == seen.stamp) {
      if (!seen.sum) continue;
      const auto text = files_.read(path, dsl::largest_file);
      if (!text || sum_of(text.value()) == *seen.sum) continue;
    }
    const FileChange::Kind kind = !now.exists         ? FileChange::Kind::removed
                                  : seen.stamp.exists ? FileChange::Kind::written
                                                      : FileChange::Kind::created;
    out.push_back({path, kind, now});
  }
  return out;
}

std::vector<std::string> WatchedFiles::paths() const { return keys_of(seen_); }

std::vector<std::string> WatchedFolders::list(const std::string& folder) {
  std::vector<std::string> found = outputs_.list(folder);
  seen_.emplace(folder, scenarios_among(found));
  return found;
}

std::vector<FileChange> WatchedFolders::changes() const {
  std::vector<FileChange> out;
  for (const auto& [folder, before] : seen_) {
    for (const std::string& path : scenarios_among(outputs_.list(folder))) {
      if (std::binary_search(before.begin(), before.end(), path)) continue;
      out.push_back({path, FileChange::Kind::created, stamp_of(path)});
    }
  }
  return out;
}

std::vector<std::string> WatchedFolders::paths() const { return keys_of(seen_); }

} // namespace director::compiler::cli
