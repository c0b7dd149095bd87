#pragma once
// SPDX-License-Identifier: MIT
// What a micro-step notes: components to be decided again, groups with a new reason to run, and the queue of runs.
// These functions are small and called from all of the engine, so they are inline.

#include "runtime/core/engine/engine.hpp"

namespace director {

// The queue of runs: the granted groups that have a reason to run, in the order in which they got it. They are linked
// in State::run_queue, so that a group can leave without a search.

/// Adds the group if it has a reason to run and is not in the queue yet.
DIRECTOR_INLINE void Engine::enter_queue(Index group) {
  Counters& c = *x_.s.counters;
  RunQueueEntry& entry = x_.s.run_queue[group];
  if (entry.pending == 0 || entry.flags.has(group_flag::queue)) return;
  entry.flags |= group_flag::queue;
  const Index last = c.queue_last;
  (last == nil ? c.queue_first : x_.s.run_queue[last].runs_before) = group;
  entry.runs_after = last;
  c.queue_last = group;
}

/// Removes and returns the first group; there must be one.
inline Index Engine::take_from_queue() {
  Counters& c = *x_.s.counters;
  const Index group = c.queue_first;
  RunQueueEntry& entry = x_.s.run_queue[group];
  const Index before = c.queue_first = std::exchange(entry.runs_before, nil);
  (before == nil ? c.queue_last : x_.s.run_queue[before].runs_after) = nil;
  entry.flags.remove(group_flag::queue);
  return group;
}

inline void Engine::leave_queue(Index group) {
  Counters& c = *x_.s.counters;
  RunQueueEntry& entry = x_.s.run_queue[group];
  if (!entry.flags.has(group_flag::queue)) return;
  entry.flags.remove(group_flag::queue);
  const Index after = entry.runs_after, before = entry.runs_before;
  (after == nil ? c.queue_first : x_.s.run_queue[after].runs_before) = before;
  (before == nil ? c.queue_last : x_.s.run_queue[before].runs_after) = after;
  entry.runs_after = entry.runs_before = nil;
}

DIRECTOR_ONE_COPY inline void Engine::mark(Index component, std::uint8_t bits) {
  Bits& all = x_.s.component[component];
  if (!all.has(work::listed)) x_.s.work[x_.s.counters->work_count++] = component;
  all |= bits;
}

/// Notes that the group becomes stale, or stale no longer, if a decision of the last pass depended on it.
DIRECTOR_ONE_COPY inline void Engine::mark_stale(Index group) {
  const RunQueueEntry& entry = x_.s.run_queue[group];
  if (entry.stale_matters != 0 || x_.s.component[entry.component].has(work::stale_matters))
    mark(entry.component, work::changed);
}

DIRECTOR_ONE_COPY inline void Engine::touch(Index group) {
  Bits& flags = x_.s.run_queue[group].flags;
  if (flags.has(group_flag::touched)) return;
  flags |= group_flag::touched;
  x_.s.touched[x_.s.counters->touched_count++] = group;
}

inline void Engine::untouch(Index group) { x_.s.run_queue[group].flags.remove(group_flag::touched); }

/// Adds bits of Reason. True if one of them is new.
inline bool Engine::note_reasons(Index group, std::uint8_t bits) {
  RunQueueEntry& entry = x_.s.run_queue[group];
  if ((bits & reason::new_task) != 0) entry.done = 0;
  const auto news = static_cast<std::uint8_t>(bits & ~entry.pending);
  entry.pending |= news;
  if ((news & reason::makes_stale) != 0) mark_stale(group);
  return news != 0;
}

/// Makes the group use the data of this request from now on; nil: its own copy.
inline void Engine::use_data_of(Index group, Index edge) {
  if (bodies_.data != nullptr) x_.s.data_from[group] = edge;
}

inline void Engine::add_reason(Index group, Reason reason) {
  if (note_reasons(group, static_cast<std::uint8_t>(reason))) touch(group);
}

/// Queues a run of a group that stays granted. `anew`: for a new request of its holder, noted as making it stale.
DIRECTOR_INLINE void Engine::queue_run(Index group, bool anew) {
  use_data_of(group, x_.s.last[group].holder);
  RunQueueEntry& entry = x_.s.run_queue[group];
  if (anew) {
    entry.pending |= reason::new_task;
    entry.done = 0;
  }
  enter_queue(group);
}

/// Removes from State::work all components that need not be decided by the next arbitration.
DIRECTOR_INLINE void Engine::forget_work() {
  Counters& c = *x_.s.counters;
  const Index before = c.work_count;
  Index left = 0;
  for (Index i = 0; i < before; ++i) {
    const Index component = x_.s.work[i];
    Bits& bits = x_.s.component[component];
    bits.remove(work::decided | work::pushes);
    if (bits.has(work::changed | work::unsettled)) {
      x_.s.work[left++] = component;
    } else {
      bits &= work::kept;
    }
  }
  c.work_count = left;
}

/// Takes the next record of the same input.
inline const Input* Engine::take_more(const Input& record) {
  const Input* const next = record.more ? inbox_.take_more() : nullptr;
  if (next != nullptr && observed()) report_input(*next);
  return next;
}

/// Notes that an edge is about to be requested at another level, or no longer.
DIRECTOR_INLINE void Engine::mark_request(Index edge) {
  const Index component = x_.s.run_queue[x_.s.request[edge].target].component;
  if (x_.t.components.size() > 1) remember_request(edge);
  arbitration::note_rerequest(x_, edge);
  mark(component, edge < x_.t.root_edges ? work::changed | work::reordered : work::changed);
}

DIRECTOR_ONE_COPY DIRECTOR_INLINE void Engine::request(Index edge, Index level) {
  Requested& request = x_.s.request[edge];
  if (Bits& anew = x_.s.anew[edge]; anew == 0) {
    anew = 1; // a task that is requested again is a new task
    x_.s.renewed[x_.s.counters->anew_count++] = edge;
  }
  if (request.level != level) {
    mark_request(edge);
    request.stamp = x_.s.counters->micro_step;
    request.level = level;
  }
  mark_stale(request.target);
  touch(request.target);
}

/// Withdraws the request. True if there was one.
DIRECTOR_INLINE bool Engine::withdraw(Index edge) {
  if (x_.s.request[edge].level == nil) return false;
  mark_request(edge);
  x_.s.request[edge].level = nil;
  return true;
}

/// Notes a value that a body or handler sets, the last one for each state.
inline void Engine::stage(Index state, std::int32_t value) {
  std::int32_t& staged = x_.s.values[state].staged;
  if (staged == unset && value != unset) x_.s.staged[x_.s.counters->staged_count++] = state;
  staged = value;
}

/// Sets the value and restarts its expiry. True if the value changes.
DIRECTOR_ONE_COPY inline bool Engine::set_value(Index state, std::int32_t value) {
  const Time expires = x_.t.states[state].expires;
  if (expires != 0) timers_.arm({Timers::Kind::expiry, state}, later(x_.s.counters->now, expires));
  return assign(state, value);
}

/// Sets the value. While it stays in an interval where no condition flips, no condition is evaluated.
inline bool Engine::assign(Index state, std::int32_t value) {
  if (x_.s.values[state].value == value) return false;
  x_.s.values[state].value = value;
  if (!x_.s.values[state].unchanged.has(value)) update_conditions(state);
  return true;
}

/// Whether a micro-step that only makes this request changes no input of arbitration: the level is the same, and no
/// decision depends on whether the target is stale. It can only cause a run.
DIRECTOR_INLINE bool Engine::repeats_request(Index edge, Index level) const {
  const Counters& c = *x_.s.counters;
  const Requested& request = x_.s.request[edge];
  if (request.level != level || (c.work_count | c.touched_count) != 0) return false;
  const RunQueueEntry& entry = x_.s.run_queue[request.target];
  return entry.stale_matters == 0 && !x_.s.component[entry.component].has(work::stale_matters);
}

/// Queues the run that such a request causes.
DIRECTOR_INLINE void Engine::run_for_repeated_request(Index edge) {
  const Index group = x_.s.request[edge].target;
  const GroupAssignment& last = x_.s.last[group];
  x_.s.counters->unsettled = false;
  if (last.granted()) queue_run(group, last.holder == edge);
  if (bodies_.data != nullptr) settle_data(edge);
}

/// Forgets the triggers that fired since the last run of the group.
inline void Engine::forget_triggers(Index group) {
  for (const Index slot : x_.t.groups[group].listens.rows()) x_.s.fired[slot] = 0;
}

DIRECTOR_ONE_COPY inline void Engine::end_wait(Index group) { timers_.disarm({Timers::Kind::wait, group}); }

} // namespace director
