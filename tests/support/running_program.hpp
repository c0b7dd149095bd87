#pragma once
// SPDX-License-Identifier: MIT
// A program of this build that runs beside the test, which reads what it prints, piece by piece.

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace director::tests {

class RunningProgram {
public:
  /// A terminal of 80 columns, 24 lines, or a pipe for both of its streams.
  enum class To { pipe, terminal };
  /// A system that has no inotify.
  enum class Without { nothing, notices };
  /// `words`: the name of a program in `bin` and its arguments.
  RunningProgram(const std::vector<std::string>& words, const std::filesystem::path& folder, To to = To::pipe,
                 Without without = Without::nothing);
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// What it prints until then, with that; fails where it ends before, or says nothing for long.
  std::string read_until(const std::string& text);
  void send(int signal) const;
  /// At the keyboard of its terminal; "\003" is Ctrl-C.
  void type(const std::string& keys) const;
  /// Waits for its end: the exit status; 128 and more, the signal that ended it.
  int wait();
  /// What it printed and nobody has read yet, up to its end.
  std::string rest();

private:
  bool read_some();

  pid_t child_ = -1;
  int output_ = -1;
  std::string unread_;
};

} // namespace director::tests
