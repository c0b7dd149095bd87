// Timers, and what is due by them: docs/semantics.md, section 3, Time.
// SPDX-License-Identifier: MIT
//
// Cost: the root of the tree is read; a change climbs as far as it matters.

#include "runtime/core/engine/notes.hpp"

namespace director {

namespace part {
const char timers = 0;
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

void Run::wait(Time duration) { wait_ = duration; }

void Engine::begin_wait(Index group, Time wait) {
  const Time due = later(x_.s.counters->now, wait);
  if (observed()) report_wait(group, due);
  x_.s.run_queue[group].flags |= group_flag::waits;
  timers_.arm({Timers::Kind::wait, group}, due);
}

void Engine::stop_waiting(Index group) {
  x_.s.run_queue[group].flags &= static_cast<std::uint8_t>(~group_flag::waits);
  timers_.disarm({Timers::Kind::wait, group});
}

/// What is due at the time being served, which began with the earliest: states that expire, waits, promises, `every`,
/// each in order of declaration. Each is an input of its own. What one of them cancels is not due any more when its
/// turn comes.
Engine::Taken Engine::take_timer() {
  Counters& c = *x_.s.counters;
  const Time when = c.next_due;
  if (when > c.now) {
    c.serving = false;
    return Taken::nothing;
  }
  const Timers::Timer timer = timers_.take_first();
  ++c.micro_step;
  if (observed()) report_timer(timer);
  return serve(timer, when) ? Taken::change : Taken::no_change;
}

/// True if that is an input with an effect.
bool Engine::serve(Timers::Timer timer, Time when) {
  const Index row = timer.row;
  switch (timer.kind) {
  case Timers::Kind::expiry: return expire(row);
  case Timers::Kind::promise: return break_promise(row);
  case Timers::Kind::wait: add_reason(row, Reason::wait); break;
  case Timers::Kind::every: end_period(row, when); break;
  }
  return true;
}

} // namespace director
