#pragma once
// SPDX-License-Identifier: MIT
// The reports of a bridge to its program, from any of its threads: counters, and notices, each of the repeating kinds
// once.

#include "runtime/dds/settings.hpp"

#include <mutex>
#include <set>
#include <utility>

namespace director::dds {

class Notes {
public:
  explicit Notes(std::function<void(const Notice&)> report) : report_(std::move(report)) {}

  void count(std::uint64_t Counts::*what, std::uint64_t by = 1);
  void set(std::uint64_t Counts::*what, std::uint64_t to);
  Counts counts() const;

  void report(Notice::Kind kind, std::string_view robot, std::string text);
  /// Reports a text the first time only, and up to a thousand different ones.
  void report_once(Notice::Kind kind, std::string_view robot, const std::string& text);

private:
  mutable std::mutex mutex_; ///< for the counters and the reported texts
  std::mutex reporting_;     ///< one thread at a time calls the program
  Counts counts_;
  std::set<std::string> reported_;
  std::function<void(const Notice&)> report_;
};

/// A text from the network made safe for a line: shortened, and without control characters.
std::string shown(std::string_view text);

} // namespace director::dds
