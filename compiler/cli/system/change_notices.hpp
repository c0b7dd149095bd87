#pragma once
// SPDX-License-Identifier: MIT
// Sleeps until the system reports that something may have changed near some files. The only user of inotify.

#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace director::compiler::cli {

class ChangeNotices {
public:
  enum class By { system, looking };
  /// `looking`, for tests: as if the system reported nothing.
  explicit ChangeNotices(By by = By::system);
  ~ChangeNotices();
  ChangeNotices(const ChangeNotices&) = delete;
  ChangeNotices& operator=(const ChangeNotices&) = delete;

  /// Watches these from now on. What does not exist is watched in the nearest existing folder above it.
  void expect(const std::vector<std::string>& files, const std::vector<std::string>& folders);

  enum class Woken { by_change, by_time, by_end };
  /// Woken `by_end` when something can be read there.
  Woken sleep(std::chrono::milliseconds most, int end);

  /// Whether the system does not report all changes, so that the caller has to poll.
  bool must_look() const { return must_look_; }

private:
  void add(const std::string& folder, std::map<int, std::string>& wanted);

  int queue_ = -1; ///< of inotify
  bool must_look_ = false;
  std::map<int, std::string> watches_; ///< by number, the folder
};

} // namespace director::compiler::cli
