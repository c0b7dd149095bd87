// docs/semantics.md, section 5: owned states, handlers and periods.
// SPDX-License-Identifier: MIT

#include "runtime/core/base/heap_sort.hpp"
#include "runtime/core/engine/notes.hpp"

namespace director {

const char part::handlers = 0;

void Engine::end_lifecycle(Index group) {
  for (const Index state : x_.t.list(x_.t.groups[group].owned)) stage(state, x_.t.states[state].initial);
  handle(group, Reason::stopped);
  timers_.disarm({Timers::Kind::every, group});
}

void Engine::handle(Index group, Reason reason) {
  const bool starts = reason == Reason::started;
  if (starts ? !x_.t.groups[group].start : !x_.t.groups[group].stop) return;
  report(starts ? Event::Kind::start : Event::Kind::stop, group);
  Handling handling(*this, group, Reasons{static_cast<std::uint8_t>(reason)});
  (starts ? bodies_.start : bodies_.stop)(bodies_.self, handling);
  if (!handling.faulted_) return;
  report(Event::Kind::fault, group);
  end_with_fault();
}

/// Calls the start handler when the group becomes live, and begins the period when its provider becomes active.
void Engine::begin_lifecycle(Index group) {
  const GroupAssignment &now = x_.s.now[group], &last = x_.s.last[group];
  if (last.active == now.active) return;
  if (last.active == nil) {
    starting_ = group;
    handle(group, Reason::started);
    starting_ = nil;
  }
  const Time every = x_.t.providers[now.active].every;
  timers_.disarm({Timers::Kind::every, group});
  if (every != 0) timers_.arm({Timers::Kind::every, group}, later(x_.s.counters->now, every));
}

/// Runs once for a late period; the next is the first multiple after `until`. A difference of times may exceed Time.
void Engine::end_period(Index group, Time when) {
  const auto period = static_cast<std::uint64_t>(x_.t.providers[x_.s.last[group].active].every);
  auto late = static_cast<std::uint64_t>(x_.s.counters->until) - static_cast<std::uint64_t>(when);
  // The remainder of `late`; a 64-bit division would be a large function on a small machine.
  std::uint64_t some = period;
  while (some <= late / 2) some *= 2;
  for (; some >= period; some /= 2) {
    if (late >= some) late -= some;
  }
  timers_.arm({Timers::Kind::every, group},
              later(x_.s.counters->until - static_cast<Time>(late), static_cast<Time>(period)));
  add_reason(group, Reason::trigger);
}

/// Takes the values that start and stop handlers set during one act as one input.
bool Engine::take_handlers_input() {
  Counters& c = *x_.s.counters;
  ++c.micro_step;
  heap_sort({x_.s.staged, c.staged_count}, [](Index a, Index b) { return a < b; });
  return commit_states(false);
}

void Handling::set(Index state, std::int32_t value) {
  if (engine_.observed()) engine_.report_value(Event::Kind::assign, group_, nil, state, value);
  engine_.stage(state, value);
}

} // namespace director
