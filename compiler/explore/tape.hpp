#pragma once
// SPDX-License-Identifier: MIT
// The choices of one micro-step: a body picks one of several. It is replayed with other picks until all were taken: no
// body has to know the choices of others.

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace director::compiler {

class Tape {
public:
  /// Picks one of 0 .. count - 1; `count` is above 0.
  std::size_t pick(std::size_t count) {
    if (at_ == picks_.size()) picks_.push_back({0, static_cast<std::uint32_t>(count)});
    return picks_[at_++].taken;
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
