#pragma once
// SPDX-License-Identifier: MIT
// When each timer is due, and which one is due first. docs/semantics.md, section 3, Time.

#include "runtime/core/base/state.hpp"

namespace director {

/// When each timer is due, and which one is due first.
class Timers {
public:
  /// In the order in which those that are due together are served.
  enum class Kind : std::uint8_t { expiry, wait, promise, every };

  struct Timer {
    Kind kind;
    Index row; ///< state, group, promise or group
  };

  Timers(const Tables& tables, const State& memory);

  /// None is due.
  void clear();
  void arm(Timer timer, Time due) { set(number(timer), due); }
  void disarm(Timer timer) {
    if (due_[number(timer)] != never) set(number(timer), never);
  }
  Time due(Timer timer) const { return due_[number(timer)]; } ///< never: it is not armed
  /// Takes away the one that is due first; there is one.
  Timer take_first();

private:
  Index number(Timer timer) const {
    return static_cast<Index>(begin_[static_cast<std::size_t>(timer.kind)] + timer.row);
  }
  Index soonest(std::size_t node) const { return node < count_ ? soonest_[node] : static_cast<Index>(node - count_); }
  Index sooner(std::size_t node) const;
  void set(Index index, Time due);

  Counters* counters_;
  Time* due_;      ///< timers, kind by kind, by declaration
  Index* soonest_; ///< node n of a tree, 2n and 2n+1 being the nodes below it and the timers its leaves: which one is
                   ///< due first
  Index begin_[4]; ///< of each kind
  Index count_;
};

} // namespace director
