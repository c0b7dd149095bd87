#pragma once
// SPDX-License-Identifier: MIT
// docs/semantics.md, section 3: the queue of runs.

#include "runtime/core/base/inline.hpp"
#include "runtime/core/base/marks.hpp"

namespace director {

/// The granted groups that have a reason to run, in the order in which they got it. They are linked in
/// State::run_queue, so that a group can leave without a search.
class RunQueue {
public:
  explicit RunQueue(const State& memory) : counters_(memory.counters), entries_(memory.run_queue) {}

  bool empty() const { return counters_->queue_first == nil; }

  /// Adds the group if it has a reason to run and is not in the queue yet.
  DIRECTOR_INLINE void enter(Index group) {
    RunQueueEntry& entry = entries_[group];
    if (entry.pending == 0 || entry.flags.has(group_flag::queue)) return;
    entry.flags |= group_flag::queue;
    const Index last = counters_->queue_last;
    (last == nil ? counters_->queue_first : entries_[last].runs_before) = group;
    entry.runs_after = last;
    counters_->queue_last = group;
  }

  /// Removes and returns the first group; the queue must not be empty.
  Index take_first() {
    const Index group = counters_->queue_first;
    RunQueueEntry& entry = entries_[group];
    const Index before = entry.runs_before;
    entry.flags.remove(group_flag::queue);
    entry.runs_before = nil;
    counters_->queue_first = before;
    (before == nil ? counters_->queue_last : entries_[before].runs_after) = nil;
    return group;
  }

  void leave(Index group) {
    RunQueueEntry& entry = entries_[group];
    if (!entry.flags.has(group_flag::queue)) return;
    entry.flags.remove(group_flag::queue);
    const Index after = entry.runs_after, before = entry.runs_before;
    (after == nil ? counters_->queue_first : entries_[after].runs_before) = before;
    (before == nil ? counters_->queue_last : entries_[before].runs_after) = after;
    entry.runs_after = entry.runs_before = nil;
  }

private:
  Counters* counters_;
  RunQueueEntry* entries_;
};

} // namespace director
