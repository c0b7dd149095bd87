// Header: compiler/cli/commands/watch.hpp. Test: tests/compiler/cli/commands/watch_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/commands/watch.hpp"

#include "compiler/base/counted.hpp"
#include "compiler/cli/input/load.hpp"
#include "compiler/cli/input/watched_files.hpp"
#include "compiler/cli/system/change_notices.hpp"
#include "dsl/source/colours.hpp"
#include "dsl/source/harmless.hpp"

#include <fmt/format.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <optional>

namespace director::compiler::cli {

namespace fs = std::filesystem;

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// The time without changes before changed files are read: saving several files, or one in several steps, causes one
/// run.
constexpr auto quiet = 10ms;
/// How long a file may be empty or gone before that counts as intended.
constexpr auto patience = 500ms;
/// A file that is written all the time is read after this time nevertheless.
constexpr auto enough = 1s;
/// The interval for polling: not all file systems report changes.
constexpr auto between_looks = 1s;
constexpr auto between_looks_without_notices = 100ms;

/// SIGINT and SIGTERM, which can be read here instead of ending the program, during its lifetime.
class EndSignals {
public:
  EndSignals() {
    ::sigemptyset(&ours_);
    ::sigaddset(&ours_, SIGINT);
    ::sigaddset(&ours_, SIGTERM);
    ::pthread_sigmask(SIG_BLOCK, &ours_, &before_);
    number_ = ::signalfd(-1, &ours_, SFD_CLOEXEC | SFD_NONBLOCK);
    if (number_ < 0) ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); // then they end the program
  }
  ~EndSignals() {
    if (number_ >= 0) ::close(number_);
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;
  int number() const { return number_; }
  /// Whether one has come, which is consumed.
  bool take() const {
    signalfd_siginfo signal{};
    return ::read(number_, &signal, sizeof signal) > 0;
  }

private:
  sigset_t ours_{}, before_{};
  int number_ = -1;
};

/// The files that a run has read.
struct World {
  explicit World(Console& console) : files(console.files), folders(console.outputs) {}
  WatchedFiles files;
  WatchedFolders folders;

  std::vector<FileChange> changes() const {
    std::vector<FileChange> out = files.changes(), more = folders.changes();
    out.insert(out.end(), more.begin(), more.end());
    return out;
  }
};

/// The changes since the run, once they have settled; empty: a signal came.
std::optional<std::vector<FileChange>> next_changes(const World& world, ChangeNotices& notices, const EndSignals& end) {
  std::vector<FileChange> known;
  Clock::time_point began{};
  while (true) {
    notices.expect(world.files.paths(), world.folders.paths());
    std::vector<FileChange> changes = world.changes();
    // Also for a new file: it is created before its content is written.
    const bool half_done =
        std::any_of(changes.begin(), changes.end(), [](const FileChange& change) { return change.may_be_half_done(); });
    if (!changes.empty()) {
      const Clock::time_point now = Clock::now();
      if (known.empty()) began = now;
      const bool is_quiet = changes == known;
      const Clock::duration since = now - began;
      if (since > enough || (is_quiet && (!half_done || since > patience))) return changes;
    }
    known = std::move(changes);
    const auto longest = !known.empty()        ? std::chrono::milliseconds(quiet)
                         : notices.must_look() ? between_looks_without_notices
                                               : std::chrono::milliseconds(between_looks);
    if (notices.sleep(longest, end.number()) == ChangeNotices::Woken::by_end && end.take()) return {};
  }
}

/// "a.yaml has changed, b.yaml is gone"
std::string words_of(const std::vector<FileChange>& changes) {
  constexpr std::size_t most = 3;
  std::string out;
  for (std::size_t i = 0; i < changes.size() && i < most; ++i) {
    const FileChange& change = changes[i];
    const char* const what = change.kind == FileChange::Kind::removed   ? "is gone"
                             : change.kind == FileChange::Kind::created ? "is new"
                                                                        : "has changed";
    out += fmt::format("{}{} {}", i == 0 ? "" : ", ", shown_path(change.path), what);
  }
  return changes.size() > most ? out + fmt::format(", and {} more", changes.size() - most) : out;
}

/// An input that can be read only once, or is no file.
std::optional<std::string> unwatchable(const std::vector<std::string>& named) {
  for (const std::string& path : named) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    const bool is_stream = fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
    if (is_stream || path == "-")
      return fmt::format("`{}` cannot be watched: it is no file that can be read again", path);
  }
  return {};
}

/// The local time of day.
std::string time_text() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  return fmt::format("{:02}:{:02}:{:02}", local.tm_hour, local.tm_min, local.tm_sec);
}

class Watching {
public:
  Watching(Console& console, const std::function<int(Console&)>& once) : console_(console), once_(once) {}

  int run() {
    std::string why;
    while (true) {
      World world(console_);
      const int status = once(world, why);
      const EndSignals end;
      print_end(status, world);
      if (!console_.out || !console_.err) return misused; // the output is closed
      const std::optional<std::vector<FileChange>> changes = next_changes(world, notices_, end);
      if (!changes) return status;
      why = words_of(*changes);
    }
  }

private:
  int once(World& world, const std::string& why) {
    if (console_.out_clears) console_.out << "\033[H\033[2J";
    line(why.empty() ? time_text() : time_text() + " " + dsl::harmless(why));
    began_ = Clock::now();
    Console watched = with_files(console_, world.files, world.folders);
    return once_(watched);
  }

  void print_end(int status, const World& world) {
    const auto took = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - began_);
    std::string what = counted(world.files.paths().size(), "file");
    if (const std::size_t folders = world.folders.paths().size(); folders != 0)
      what += " and " + counted(folders, "folder");
    line(fmt::format("status {} after {} ms; watching {}, Ctrl-C ends", status, took.count(), what));
  }

  void line(const std::string& text) {
    console_.err.flush();
    console_.out << dsl::painted("== " + text, dsl::colours::grey, console_.out_colours) << "\n" << std::flush;
  }

  Console& console_;
  const std::function<int(Console&)>& once_;
  ChangeNotices notices_;
  Clock::time_point began_{};
};

} // namespace

int watch(const std::vector<std::string>& named, Console& console, const std::function<int(Console&)>& once) {
  if (const std::optional<std::string> wrong = unwatchable(named)) {
    print_message(console, fmt::format("directorc: {}\n", *wrong));
    return misused;
  }
  return Watching(console, once).run();
}

} // namespace director::compiler::cli
