// docs/semantics.md, section 3, Time: timers, and what follows when they are due.
// SPDX-License-Identifier: MIT

#include "runtime/core/engine/notes.hpp"

namespace director {

const char part::timers = 0;

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

void Run::wait(Time duration) { wait_ = duration; }

void Engine::begin_wait(Index group, Time wait) {
  const Time due = wait == never ? never : later(x_.s.counters->now, wait); // the time may be negative
  if (observed()) report_wait(group, due);
  timers_.arm({Timers::Kind::wait, group}, due);
}

/// Takes the next due timer, as an input of its own, which may cancel others that are due. True if it has an effect.
bool Engine::take_timer() {
  const Time when = x_.s.counters->next_due;
  const Timers::Timer timer = timers_.take_first();
  ++x_.s.counters->micro_step;
  if (observed()) report_timer(timer);
  switch (timer.kind) {
  case Timers::Kind::expiry: return expire(timer.row);
  case Timers::Kind::promise: return break_promise(timer.row);
  case Timers::Kind::wait: add_reason(timer.row, Reason::wait); break;
  case Timers::Kind::every: end_period(timer.row, when); break;
  }
  return true;
}

} // namespace director
