#pragma once
// SPDX-License-Identifier: MIT
// The progress of an exploration on a terminal: one line that is overwritten.

#include "compiler/cli/system/console.hpp"
#include "compiler/explore/search/search.hpp"

#include <chrono>
#include <string>

namespace director::compiler::cli {

/// "12345 states (1.2 % of the bound), 80 % of them explored, 24100 a second, 5.2 MB". `elapsed`: since the beginning.
std::string progress_text(const SearchProgress& so_far, std::size_t bound, std::chrono::milliseconds elapsed);

class Progress {
public:
  /// `bound`: the limit for states. Nothing is printed if the error stream is no terminal.
  Progress(Console& console, std::size_t bound) : console_(console), bound_(bound) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Erases the line.
  ~Progress();

  /// For SearchOptions; empty if nothing is printed. It must not outlive this.
  std::function<void(const SearchProgress& so_far)> shown();

private:
  using Clock = std::chrono::steady_clock;
  void show(const SearchProgress& so_far);

  Console& console_;
  std::size_t bound_;
  Clock::time_point began_ = Clock::now(), last_ = began_;
  bool is_shown_ = false;
};

} // namespace director::compiler::cli
