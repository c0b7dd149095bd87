#pragma once
// SPDX-License-Identifier: MIT
// Enumerates all ways through a computation that picks one of several at some points: it is repeated, each time with
// the next picks, until all were taken. No point has to know of the others.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace director::compiler {

class ChoiceSequence {
public:
  /// Picks one of 0 .. count - 1; `count` is above 0.
  std::size_t pick(std::size_t count) {
    if (count < 2 && at_ >= fixed_) return 0;
    if (at_ == picks_.size()) picks_.push_back({0, static_cast<std::uint32_t>(count)});
    return picks_[at_++].taken;
  }
  bool any() { return pick(2) == 1; }

  /// Whether this way has left the part that it shares with the one before.
  bool has_picked() const { return !picks_.empty() && at_ == picks_.size(); }
  /// Whether every pick is the first.
  bool usual() const {
    return std::all_of(picks_.begin(), picks_.end(), [](const Pick& pick) { return pick.taken == 0; });
  }

  /// Back to the beginning, with the next picks. False: there are no others.
  bool next() {
    picks_.resize(at_);
    at_ = 0;
    while (picks_.size() > fixed_) {
      if (++picks_.back().taken < picks_.back().count) return true;
      picks_.pop_back();
    }
    return false;
  }
  /// Restarts with the first picks; of these, the given ones stay fixed.
  void begin(std::initializer_list<std::size_t> given = {}) {
    picks_.clear();
    for (const std::size_t taken : given) picks_.push_back({static_cast<std::uint32_t>(taken), 0});
    fixed_ = picks_.size();
    at_ = 0;
  }

private:
  struct Pick {
    std::uint32_t taken, count;
  };
  std::vector<Pick> picks_;
  std::size_t at_ = 0, fixed_ = 0;
};

} // namespace director::compiler
