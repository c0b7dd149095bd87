#pragma once
// SPDX-License-Identifier: MIT
// A program that a test starts, reads and kills.

#include <sys/types.h>

#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace director::tests {

class Process {
public:
  explicit Process(const std::vector<std::string>& words);
  /// Kills the process if it still runs.
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void signal(int number);
  int wait();                       ///< waits for its exit code; less than 0 if a signal ended it
  std::vector<std::string> lines(); ///< the lines printed so far

private:
  void read(int from);

  pid_t id_ = 0;
  int status_ = 0;
  std::mutex mutex_;
  std::vector<std::string> lines_;
  std::thread reader_;
};

} // namespace director::tests
