// Door: runtime/core/engine/engine.hpp. Test: tests/runtime/core/engine/engine_test.cpp.
// SPDX-License-Identifier: MIT
//
// Section 5: acting on the difference between the last assignment and the new one. First stops, in the old order, so
// that a group is cleaned up before others begin; then, in the new order, starts and reasons to run.

#include "runtime/core/base/heap_sort.hpp"
#include "runtime/core/engine/notes.hpp"
#include "runtime/core/base/fault_injection.hpp"

namespace director {

void Engine::act(Index passes, bool stops) {
  for (Index i = 0; i < passes && observed(); ++i) report_decisions(s_.work[i]);
  if (stops) {
    for (const Index group : held_before(passes)) {
      if (s_.now[group].stops_after(s_.last[group])) stop_group(group);
    }
  }
  for (const Index group : with_reasons()) give_reasons(group);
  adopt_differing();
  for (Index i = 0; i < passes; ++i) {
    adopt_order(s_.work[i]);
    keep_promises_in(s_.work[i]);
  }
}

/// Nothing was arbitrated, so nothing starts, stops or changes hands: only what is granted can gain a reason to run.
void Engine::act_on_touched() {
  Counters& c = *s_.counters;
  if (c.touched_count != 1) return act_on_all_touched();
  c.touched_count = 0;
  const Index group = s_.touched[0];
  untouch(group);
  if (granted(group)) give_again(group, s_.request[s_.last[group].holder].anew != 0);
}

void Engine::act_on_all_touched() {
  Counters& c = *s_.counters;
  const Index touched = c.touched_count;
  c.touched_count = 0;
  Index count = 0, last = nil; // component
  bool sorted = true;          // as what one pack asks for mostly comes
  for (Index i = 0; i < touched; ++i) {
    const Index group = s_.touched[i];
    untouch(group);
    if (!granted(group)) continue;
    const Index component = s_.run_queue[group].component;
    if (count != 0) sorted = sorted && component == last && s_.place[s_.touched[count - 1]] < s_.place[group];
    last = component;
    s_.touched[count++] = group;
  }
  if (!sorted) sort_by_place({s_.touched, count}, Chains::previous);
  for (Index i = 0; i < count; ++i) give_again(s_.touched[i], s_.request[s_.last[s_.touched[i]].holder].anew != 0);
}

/// In the order of all: the groups of one component know their places.
void Engine::sort_by_place(std::span<Index> groups, Chains along) const {
  heap_sort(groups, [&](Index a, Index b) {
    if (t_.groups[a].component == t_.groups[b].component) return s_.place[a] < s_.place[b];
    return before_in_order(a, b, along);
  });
}

/// What was held in the components decided again, in the old order.
std::span<const Index> Engine::held_before(Index passes) {
  const auto part = [&](Index component) {
    return std::span<const Index>{s_.order + t_.components[component].order, s_.order_count[component]};
  };
  if (passes == 1) return part(s_.work[0]);
  Index count = 0;
  for (Index i = 0; i < passes; ++i) {
    for (const Index group : part(s_.work[i])) s_.sorted[count++] = group;
  }
  sort({s_.sorted, count}, Chains::previous);
  return {s_.sorted, count};
}

/// What is granted and can have a new reason to run, in the new order: it stands elsewhere than before, or was touched.
std::span<const Index> Engine::with_reasons() {
  const Counters& c = *s_.counters;
  const auto decided = [&](Index g) { return (s_.component[t_.groups[g].component] & work::passed) != 0; };
  Index count = 0;
  for (Index i = 0; i < differing_; ++i) {
    const Index group = s_.differing[i];
    if (s_.now[group].granted()) s_.sorted[count++] = group;
  }
  for (Index i = 0; i < c.touched_count; ++i) {
    const Index group = s_.touched[i];
    if (!decided(group)) {
      if (!granted(group) || injected(Fault::others_are_overlooked)) continue;
    } else if ((s_.group_marks[group] & mark::differs) != 0 || !s_.now[group].granted() ||
               injected(Fault::who_stands_as_before_is_overlooked)) {
      continue;
    }
    s_.sorted[count++] = group;
  }
  sort_by_place({s_.sorted, count}, Chains::current);
  return {s_.sorted, count};
}

/// What few groups have: states of their own, a handler, a period.
void Engine::end_what_it_has(Index group) {
  for (const Index state : t_.list(t_.groups[group].owned)) {
    if (!injected(Fault::owned_states_stay)) set_by_handler(state, t_.states[state].initial);
  }
  handle(group, Reason::stopped);
  disarm(Due::every, group);
}

void Engine::stop_group(Index group) {
  RunQueueEntry& entry = s_.run_queue[group];
  if ((entry.flags & group_flag::ends) != 0) end_what_it_has(group);
  entry.pending = entry.done = 0;
  end_wait(group);
  live_on(group, nil);
  forget_triggers(group);
  for (Index e = entry.edges.begin; e != entry.edges.end; ++e) {
    if (injected(Fault::stopped_requests_stand)) continue;
    if (s_.request[e].level == nil) continue;
    s_.request[e].level = nil;
    note_rerequest(e);
  }
}

/// Calls the start or stop handler.
void Engine::handle(Index group, Reason reason) {
  const bool starts = reason == Reason::started;
  if (starts ? !t_.groups[group].start : !t_.groups[group].stop) return;
  report(starts ? Event::Kind::start : Event::Kind::stop, group);
  Handling handling(*this, group, Reasons{static_cast<std::uint8_t>(reason)});
  inside_ = true;
  (starts ? bodies_.start : bodies_.stop)[group](bodies_.self, handling);
  inside_ = false;
  if (!handling.faulted_) return;
  report(Event::Kind::fault, group);
  end_with_fault();
}

/// Why a group that is granted is to run, but for what is asked for anew.
std::uint8_t Engine::reasons(const GroupAssignment& last, const GroupAssignment& now) {
  std::uint8_t bits = 0;
  const bool handed_on = last.holder != now.holder && !injected(Fault::a_new_holder_is_no_news);
  if (last.active == nil || !last.granted() || handed_on) bits |= reason::new_task;
  if (last.active != now.active) bits |= (now.flags & flag::in_force) != 0 ? reason::pushed : reason::new_task;
  const bool served = (last.flags & flag::serving) != 0 && now.push.provider == last.push.provider &&
                      now.push.condition == last.push.condition;
  if ((now.flags & flag::serving) != 0 && !served && !injected(Fault::a_lost_state_is_nobodys_concern))
    bits |= reason::pushed;
  return bits;
}

/// What follows besides: a start handler is called, or a period ends or begins.
bool Engine::takes_more(Index group, const GroupAssignment& last, const GroupAssignment& now) const {
  if (last.active == nil && t_.groups[group].start) return true;
  const auto every = [&](Index provider) { return provider != nil && t_.providers[provider].every != 0; };
  return last.active != now.active && (every(last.active) || every(now.active));
}

/// The start handler is called where the group becomes live, and a period ends or begins.
void Engine::begin(Index group, const GroupAssignment& now) {
  if (s_.last[group].active == nil) {
    live_on(group, now.holder);
    starting_ = group;
    handle(group, Reason::started);
    starting_ = nil;
  }
  const Time every = t_.providers[now.active].every; // the period begins when the provider becomes active
  disarm(Due::every, group);
  if (every != 0) arm(Due::every, group, later(s_.counters->now, every));
}

/// To a group that is granted and stands elsewhere than before, or was touched.
void Engine::give_reasons(Index group) {
  const GroupAssignment &now = s_.now[group], &last = s_.last[group];
  if (takes_more(group, last, now) && !injected(Fault::handlers_are_overlooked)) begin(group, now);
  note_given(group, now.holder, reasons(last, now));
  enqueue(group);
}

/// Section 7: a promise ends with its push, and when its condition has come true.
void Engine::keep_promises(Index group) {
  Promised& promised = s_.promised[group];
  const Index provider = promised.provider;
  if (provider == nil) return;
  const Push& push = s_.last[group].push;
  const bool stands = in_force(group) && push.edge == promised.edge && push.provider == provider;
  const Range promises = t_.providers[provider].promises;
  for (Index i = promises.begin; i != promises.end; ++i) {
    if (!stands || holds(t_.promises[i].condition)) disarm(Due::promise, i);
  }
  if (!stands) promised = {};
}

/// The data of a new request take their slot. What was there is kept for a group that still lives on it.
void Engine::settle_data(Index edge) {
  const Index group = t_.edges[edge].target;
  const bool given = granted(group) && s_.last[group].holder == edge;
  if (!given && s_.last[group].active != nil && s_.data_from[group] == edge) {
    bodies_.data(bodies_.self, Bodies::Data::retain, edge, nil);
    live_on(group, nil);
  }
  bodies_.data(bodies_.self, Bodies::Data::settle, edge, nil);
}

/// The new assignment becomes the last one. Runs of groups that are not granted leave the queue; what is pending stays.
inline void Engine::adopt(Index group) {
  if (!s_.now[group].granted() && !injected(Fault::who_leaves_stays_queued)) leave_queue(group);
  s_.group_marks[group] &= static_cast<std::uint8_t>(~mark::differs);
  s_.last[group] = s_.now[group];
  const Range slots = t_.groups[group].slots;
  for (Index slot = slots.begin; slot != slots.end; ++slot) s_.last.plan[slot] = s_.now.plan[slot];
}

inline void Engine::adopt_differing() {
  Counters& c = *s_.counters;
  for (Index i = 0; i < c.touched_count; ++i) untouch(s_.touched[i]);
  c.touched_count = 0;
  for (Index i = 0; i < differing_; ++i) adopt(s_.differing[i]);
}

void Engine::adopt_order(Index component) {
  if (injected(Fault::the_order_stays)) return;
  const Component& row = t_.components[component];
  const Index count = s_.order_count[component] = s_.next_count[component];
  const Index* const next = s_.next_order + row.order;
  Index* const order = s_.order + row.order;
  for (Index i = s_.first_moved[component]; i < count; ++i) order[i] = next[i];
}

void Engine::report_decisions(Index component) const {
  if (!observed()) return;
  const Component& row = t_.components[component];
  for (const Index g : t_.list(row.groups)) {
    if (s_.last[g].push.edge != nil && s_.now[g].push.edge == nil) tell(event(Event::Kind::release, g));
  }
  for (const Index g : t_.list(row.groups)) {
    const Push &now = s_.now[g].push, &last = s_.last[g].push;
    if (now.edge == nil || (now.edge == last.edge && now.provider == last.provider)) continue;
    Event push = event(Event::Kind::push, g);
    push.provider = now.provider;
    push.edge = now.edge;
    push.condition = now.condition;
    tell(push);
  }
  report_queued(component);
  for (const Index g : t_.list(row.groups)) {
    const Index now = s_.now[g].holder, last = s_.last[g].holder;
    if (now == last) continue;
    Event control = event(now == nil ? Event::Kind::lose : Event::Kind::grant, g);
    control.edge = now;
    control.other = last;
    control.provider = s_.now[g].active;
    tell(control);
  }
}

void Engine::report_queued(Index component) const {
  if (!observed()) return;
  for (const Index e : t_.list(t_.components[component].edges)) {
    const Queued &now = s_.queued[e], &last = s_.last_queued[e];
    if (now.why == Why::none || now == last) continue;
    Event queue = event(Event::Kind::queue, t_.edges[e].target);
    queue.edge = e;
    queue.why = now.why;
    queue.condition = now.condition;
    tell(queue);
  }
}

} // namespace director
