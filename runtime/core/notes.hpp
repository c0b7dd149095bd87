#pragma once
// What a micro-step notes on its way: components to be decided again, groups with a new reason, the run queue, timers
// that are off. Small, and called from everywhere in it: so it is inline, and only the engine's own files include it.

#include "runtime/core/engine.hpp"
#include "runtime/core/marks.hpp"
#include "runtime/core/planted.hpp"

namespace director {

inline void Engine::mark(Index component, std::uint8_t bits) {
  std::uint8_t& all = s_.component[component];
  all |= bits;
  if ((all & work::listed) != 0) return;
  all |= work::listed;
  s_.work[s_.counters->work_count++] = component;
}

/// Whose orders are outdated may be another from now on.
inline void Engine::mark_stale(Index group) {
  const Index component = t_.groups[group].component;
  if ((s_.in_queue[group] & place::counts) != 0) {
    mark(component, work::changed);
  } else if ((s_.component[component] & work::stale_counts) != 0) {
    mark(component, work::stale_changed);
  }
}

inline void Engine::touch(Index group) {
  if ((s_.in_queue[group] & place::touched) != 0) return;
  s_.in_queue[group] |= place::touched;
  s_.touched[s_.counters->touched_count++] = group;
}

inline void Engine::untouch(Index group) { s_.in_queue[group] &= static_cast<std::uint8_t>(~place::touched); }

inline void Engine::add_reason(Index group, Reason reason) {
  const auto bit = static_cast<std::uint8_t>(reason);
  if (reason == Reason::new_task && !planted(Fault::done_outlives_a_new_task)) s_.done[group] = 0;
  if ((s_.pending[group] & bit) != 0) return;
  s_.pending[group] |= bit;
  touch(group);
  if (reason == Reason::new_task || reason == Reason::pushed) mark_stale(group);
}

// The run queue: groups linked in the order in which they are to run, so that one that is not granted any more leaves
// without a look at the others.

inline void Engine::enqueue(Index group) {
  if (s_.pending[group] == 0 || (s_.in_queue[group] & place::queue) != 0) return;
  s_.in_queue[group] |= place::queue;
  Counters& c = *s_.counters;
  (c.queue_last == nil ? c.queue_first : s_.runs_before[c.queue_last]) = group;
  s_.runs_after[group] = c.queue_last;
  c.queue_last = group;
}

inline void Engine::leave_queue(Index group) {
  if ((s_.in_queue[group] & place::queue) == 0) return;
  s_.in_queue[group] &= static_cast<std::uint8_t>(~place::queue);
  Counters& c = *s_.counters;
  Index &after = s_.runs_after[group], &before = s_.runs_before[group];
  (after == nil ? c.queue_first : s_.runs_before[after]) = before;
  (before == nil ? c.queue_last : s_.runs_after[before]) = after;
  after = before = nil;
}

/// Every micro-step ends here.
inline void Engine::end_micro_step() {
  const Counters& c = *s_.counters;
  s_.counters->unsettled = 0;
  if (c.work_count != 0) {
    arbitrate();
  } else if (c.touched_count != 0) {
    act_on_touched();
  }
  if (ran_ != nil && s_.promised_provider[ran_] != nil) keep_promises(ran_);
  if (c.asked_count != 0) settle_requests();
}

inline Index Engine::timer(Due kind, Index row) const {
  switch (kind) {
  case Due::expiry: break;
  case Due::wait: return static_cast<Index>(t_.states.size() + row);
  case Due::promise: return static_cast<Index>(t_.states.size() + t_.groups.size() + row);
  case Due::every: return static_cast<Index>(t_.states.size() + t_.groups.size() + t_.promises.size() + row);
  }
  return row;
}

inline void Engine::disarm(Due kind, Index row) {
  const Index index = timer(kind, row);
  if (s_.due[index] != never) set_timer(index, never);
}

} // namespace director
