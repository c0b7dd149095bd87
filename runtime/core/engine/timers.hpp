#pragma once
// SPDX-License-Identifier: MIT
// docs/semantics.md, section 3, Time. A part (base/parts.hpp): unless the tables or a body name it, no timer is armed.

#include "runtime/core/base/parts.hpp"
#include "runtime/core/base/state.hpp"

namespace director {

/// The times of all timers, and the timer that is due first.
class Timers {
public:
  /// In the order in which timers that are due together are served.
  enum class Kind : std::uint8_t { expiry, wait, promise, every };

  struct Timer {
    Kind kind;
    Index row; ///< state, group, promise or group
  };

  Timers(const Tables& t, const State& memory)
      : counters_(memory.counters),
        due_(memory.due),
        soonest_(memory.soonest),
        begin_{0, static_cast<Index>(t.states.size()), static_cast<Index>(begin_[1] + t.groups.size()),
               static_cast<Index>(begin_[2] + t.promises.size())},
        count_(static_cast<Index>(begin_[3] + t.groups.size())) {}

  /// Disarms all timers; of each two the first one counts as sooner.
  void clear() {
    for (Index i = 0; i < count_; ++i) due_[i] = never;
    for (std::size_t node = count_; node-- > 1;) {
      const Index a = soonest(2 * node), b = soonest(2 * node + 1);
      soonest_[node] = a < b ? a : b;
    }
    counters_->next_due = never;
  }
  void arm(Timer timer, Time due) { set(number(timer), due); }
  void disarm(Timer timer) {
    if (due_[number(timer)] != never) set(number(timer), never);
  }
  Time due(Timer timer) const { return due_[number(timer)]; } ///< never: it is not armed
  /// Disarms and returns the timer that is due first; one must be armed.
  DIRECTOR_PART Timer take_first();

private:
  Index number(Timer timer) const {
    return static_cast<Index>(begin_[static_cast<std::size_t>(timer.kind)] + timer.row);
  }
  Index soonest(std::size_t node) const { return node < count_ ? soonest_[node] : static_cast<Index>(node - count_); }
  Index sooner(std::size_t node) const;
  DIRECTOR_PART void set(Index index, Time due);

  Counters* counters_;
  Time* due_;      ///< timers, kind by kind, by declaration
  Index* soonest_; ///< node n of a tree, with nodes 2n and 2n+1 below it and the timers as leaves: the timer due first
  Index begin_[4]; ///< the first timer of each kind
  Index count_;
};

} // namespace director
