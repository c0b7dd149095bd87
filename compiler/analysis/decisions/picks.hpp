#pragma once
// SPDX-License-Identifier: MIT
// Enumerates all ways through a computation that picks at some points: it is repeated, each time with other picks.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace director::analysis {

class Picks {
public:
  /// Picks one of `count`.
  std::size_t pick(std::size_t count) {
    if (count < 2) return 0;
    if (at_ == picked_.size()) picked_.push_back({0, static_cast<std::uint32_t>(count)});
    return picked_[at_++].now;
  }
  bool any() { return pick(2) == 1; }

  /// Whether this way has left the part that it shares with the one before.
  bool has_picked() const { return !picked_.empty() && at_ == picked_.size(); }

  /// Restarts with other picks. False: there are none left.
  bool again() {
    while (!picked_.empty() && picked_.back().now + 1 == picked_.back().count) picked_.pop_back();
    at_ = 0;
    if (picked_.empty()) return false;
    ++picked_.back().now;
    return true;
  }

  void clear() {
    picked_.clear();
    at_ = 0;
  }

private:
  struct Pick {
    std::uint32_t now, count;
  };
  std::vector<Pick> picked_;
  std::size_t at_ = 0;
};

} // namespace director::analysis
