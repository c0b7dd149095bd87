#pragma once
// SPDX-License-Identifier: MIT
// What a bridge has to say to its program, from any of its threads: numbers, and notices, each of the repeating kinds
// once.

#include "runtime/dds/settings.hpp"

#include <mutex>
#include <set>
#include <utility>

namespace director::dds {

class Notes {
public:
  explicit Notes(std::function<void(const Notice&)> tell) : tell_(std::move(tell)) {}

  void count(std::uint64_t Counts::*what, std::uint64_t by = 1);
  void set(std::uint64_t Counts::*what, std::uint64_t to);
  Counts counts() const;

  void tell(Notice::Kind kind, std::string_view robot, std::string text);
  /// Only the first time that this text is said. After a thousand different ones no more.
  void tell_once(Notice::Kind kind, std::string_view robot, const std::string& text);

private:
  mutable std::mutex mutex_; ///< of the numbers and of what was said
  std::mutex telling_;       ///< one thread at a time calls the program
  Counts counts_;
  std::set<std::string> said_;
  std::function<void(const Notice&)> tell_;
};

/// A text from the network, fit for a line: short, and without what a terminal would obey.
std::string shown(std::string_view text);

} // namespace director::dds
