#pragma once
// SPDX-License-Identifier: MIT
// The choices of one micro-step, as they come: a body picks one of so many. Played again and again, each time with the
// next picks, until all were taken: no body has to know what the others may choose.

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace director::compiler {

class Tape {
public:
  /// One of 0 .. count - 1; above 0.
  std::size_t pick(std::size_t count) {
    if (at_ == picks_.size()) picks_.push_back({0, static_cast<std::uint32_t>(count)});
    return picks_[at_++].taken;
  }
  /// Back to the begin, with the next picks. False: there are no others.
  bool next() {
    picks_.resize(at_);
    at_ = 0;
    while (picks_.size() > fixed_) {
      if (++picks_.back().taken < picks_.back().count) return true;
      picks_.pop_back();
    }
    return false;
  }
  /// From the first picks again; of these, the first ones stay as they are given.
  void begin(std::initializer_list<std::size_t> given = {}) {
    picks_.clear();
    for (const std::size_t taken : given) picks_.push_back({static_cast<std::uint32_t>(taken), 0});
    fixed_ = picks_.size();
    at_ = 0;
  }
  /// Every pick is the first.
  bool usual() const {
    for (const Pick& pick : picks_) {
      if (pick.taken != 0) return false;
    }
    return true;
  }

private:
  struct Pick {
    std::uint32_t taken, count;
  };
  std::vector<Pick> picks_;
  std::size_t at_ = 0, fixed_ = 0;
};

} // namespace director::compiler
