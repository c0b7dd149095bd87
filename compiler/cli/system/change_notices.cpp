// Header: compiler/cli/system/change_notices.hpp. Test: tests/compiler/cli/system/change_notices_test.cpp.
// SPDX-License-Identifier: MIT
//
// Watches folders and not their files: an editor that saves by renaming replaces the file, and a watch would stay with
// the old one.
#include "compiler/cli/system/change_notices.hpp"

#include "compiler/base/absolute_path.hpp"
#include "compiler/cli/system/console.hpp"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <filesystem>

namespace director::compiler::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t watched_events = IN_MODIFY | IN_CLOSE_WRITE | IN_ATTRIB | IN_CREATE | IN_DELETE |
                                         IN_MOVED_FROM | IN_MOVED_TO | IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;

/// That folder, or the nearest existing one above it.
std::string existing(fs::path folder) {
  std::error_code error;
  while (!fs::is_directory(folder, error) && folder.has_relative_path()) folder = folder.parent_path();
  return folder.string();
}

} // namespace

ChangeNotices::ChangeNotices(By by) {
  if (by == By::system) queue_ = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  must_look_ = queue_ < 0;
}

ChangeNotices::~ChangeNotices() {
  if (queue_ >= 0) ::close(queue_);
}

void ChangeNotices::add(const std::string& folder, std::map<int, std::string>& wanted) {
  const int number = ::inotify_add_watch(queue_, folder.c_str(), watched_events);
  if (number >= 0) {
    wanted.emplace(number, folder);
  } else if (errno != ENOENT && errno != ENOTDIR) {
    must_look_ = true; // one that must not be read, or there are too many
  }
}

void ChangeNotices::expect(const std::vector<std::string>& files, const std::vector<std::string>& folders) {
  if (queue_ < 0) return;
  must_look_ = false;
  std::map<int, std::string> wanted;
  for (const std::string& file : files) {
    add(existing(absolute_path(file).lexically_normal().parent_path()), wanted);
    std::error_code error;
    if (!fs::is_symlink(file, error)) continue;
    const fs::path target = fs::weakly_canonical(file, error);
    if (!error) add(existing(target.parent_path()), wanted);
  }
  for (const std::string& folder : folders) {
    add(existing(absolute_path(folder).lexically_normal()), wanted);
    for (const std::string& below : all_below(folder).folders) add(below, wanted);
  }
  for (const auto& [number, folder] : watches_) {
    if (!wanted.contains(number)) ::inotify_rm_watch(queue_, number); // also of one that is gone: that fails
  }
  watches_ = std::move(wanted);
}

ChangeNotices::Woken ChangeNotices::sleep(std::chrono::milliseconds most, int end) {
  std::array<pollfd, 2> wanted{{{end, POLLIN, 0}, {queue_, POLLIN, 0}}};
  const int ready = ::poll(wanted.data(), queue_ < 0 ? 1 : 2, static_cast<int>(most.count()));
  if (ready <= 0) return Woken::by_time;
  if (wanted[0].revents != 0) return Woken::by_end;
  // The content of the events does not matter: the caller compares the files.
  alignas(inotify_event) std::array<char, 16384> events{};
  while (::read(queue_, events.data(), events.size()) > 0) {}
  return Woken::by_change;
}

} // namespace director::compiler::cli
