// docs/semantics.md, section 3, Time.
// SPDX-License-Identifier: MIT
//
// Cost: the root of the tree is read; a change climbs as far as it matters.

#include "runtime/core/engine/timers.hpp"

namespace director {

Timers::Timers(const Tables& t, const State& memory)
    : counters_(memory.counters),
      due_(memory.due),
      soonest_(memory.soonest),
      begin_{0, static_cast<Index>(t.states.size()), static_cast<Index>(begin_[1] + t.groups.size()),
             static_cast<Index>(begin_[2] + t.promises.size())},
      count_(static_cast<Index>(begin_[3] + t.groups.size())) {}

void Timers::clear() {
  for (Index i = 0; i < count_; ++i) due_[i] = never;
  for (std::size_t node = count_; node-- > 1;) soonest_[node] = sooner(node);
  counters_->next_due = never;
}

Timers::Timer Timers::take_first() {
  const Index index = soonest(1);
  set(index, never);
  std::size_t kind = 3;
  while (begin_[kind] > index) --kind;
  return {static_cast<Kind>(kind), static_cast<Index>(index - begin_[kind])};
}

Index Timers::sooner(std::size_t node) const {
  const Index a = soonest(2 * node), b = soonest(2 * node + 1);
  if (due_[a] != due_[b]) return due_[a] < due_[b] ? a : b;
  return a < b ? a : b;
}

void Timers::set(Index index, Time due) {
  due_[index] = due;
  for (std::size_t node = (std::size_t{index} + count_) / 2; node >= 1; node /= 2) {
    const Index first = sooner(node);
    if (soonest_[node] == first && first != index) return;
    soonest_[node] = first;
  }
  counters_->next_due = due_[soonest(1)];
}

} // namespace director
