// docs/semantics.md, sections 3 and 5: after every micro-step, arbitrate and act on the difference.
// SPDX-License-Identifier: MIT

#include "runtime/core/engine/notes.hpp"

namespace director {

void Engine::arbitrate() {
  const Index passes = x_.s.counters->work_count;
  if (passes > 1) sort_work();
  bool stops = false;
  differing_ = 0;
  for (Index i = 0; i < passes; ++i) {
    const Index component = x_.s.work[i];
    if (observed()) remember_queued(component);
    ++passes_;
    arbitration::decide(x_, component);
    const bool other = changed(stops);
    arbitration::end(x_);
    std::uint8_t left = x_.depends_on_all_stale ? work::stale_matters : 0;
    if (other && x_.depends_on_last) left |= work::unsettled;
    if (x_.pushed_count != 0) left |= work::pushes;
    x_.s.component[component] = left | work::decided;
  }
  act(passes, stops);
  if (x_.before_count != 0) forget_altered();
  forget_work();
}

/// Whether the new assignment of the component differs from the last one. If holders, providers, grants or pushes do,
/// arbitration is repeated at rest. `stops`: a group is not live any more.
bool Engine::changed(bool& stops) {
  const Index before = differing_;
  bool decision = false;
  for (const Index g : arbitration::opened(x_)) {
    const GroupAssignment &now = x_.s.now[g], &last = x_.s.last[g];
    if (now == last && !(x_.row.alternatives && other_plan(g))) continue;
    x_.s.group_marks[g] |= mark::differs;
    x_.s.group_trail[g] |= trail::disturbed;
    x_.s.differing[differing_++] = g;
    decision = decision || now.decides_otherwise_than(last);
    stops = stops || now.stops_after(last);
  }
  if (decision) x_.s.counters->unsettled = true;
  return differing_ != before;
}

/// Acts on the difference: first stops, in the old order, so that groups clean up before others start; then, in the new
/// order, starts and reasons to run. The new assignment becomes the last one.
void Engine::act(Index passes, bool stops) {
  Counters& c = *x_.s.counters;
  for (Index i = 0; i < passes && observed(); ++i) report_decisions(x_.s.work[i]);
  if (stops) {
    for (const Index group : passes == 1 ? held_in(x_.s.work[0]) : held_in_all(passes)) {
      if (x_.s.now[group].stops_after(x_.s.last[group])) stop_group(group);
    }
  }
  for (const Index group : with_reasons()) give_reasons(group);
  for (Index i = 0; i < c.touched_count; ++i) untouch(x_.s.touched[i]);
  c.touched_count = 0;
  for (Index i = 0; i < differing_; ++i) {
    const Index group = x_.s.differing[i];
    if (!x_.s.now[group].granted()) leave_queue(group); // its pending reasons stay
    x_.s.group_marks[group].remove(mark::differs);
    x_.s.last[group] = x_.s.now[group];
    for (const Index slot : x_.t.groups[group].slots.rows()) x_.s.last.plan[slot] = x_.s.now.plan[slot];
  }
  for (Index i = 0; i < passes; ++i) {
    adopt_order(x_.s.work[i]);
    if (!x_.t.promises.empty() && (x_.s.component[x_.s.work[i]] & work::pushes) != 0) keep_promises_in(x_.s.work[i]);
  }
}

/// Acts without arbitration: nothing starts, stops or changes hands; granted groups can get a reason to run.
void Engine::act_on_touched() {
  Counters& c = *x_.s.counters;
  if (c.touched_count != 1) return act_on_all_touched();
  c.touched_count = 0;
  const Index group = x_.s.touched[0];
  untouch(group);
  if (granted(group)) queue_run(group, x_.s.anew[x_.s.last[group].holder] != 0);
}

/// Granted groups that may have a new reason to run, in the new order: their assignment differs, or they were touched.
/// The new assignment of a component that was not decided equals the last one.
std::span<const Index> Engine::with_reasons() {
  const Counters& c = *x_.s.counters;
  Index count = 0;
  for (Index i = 0; i < differing_; ++i) {
    const Index group = x_.s.differing[i];
    if (x_.s.now[group].granted()) x_.s.reach[count++] = group;
  }
  for (Index i = 0; i < c.touched_count; ++i) {
    const Index group = x_.s.touched[i];
    if (x_.s.now[group].granted() && !x_.s.group_marks[group].has(mark::differs)) x_.s.reach[count++] = group;
  }
  if (count > 1) arbitration::sort_by_place(x_, {x_.s.reach, count}, arbitration::Chains::current);
  return {x_.s.reach, count};
}

void Engine::stop_group(Index group) {
  RunQueueEntry& entry = x_.s.run_queue[group];
  if (entry.flags.has(group_flag::lifecycle)) end_lifecycle(group);
  entry.pending = entry.done = 0;
  end_wait(group);
  use_data_of(group, nil);
  forget_triggers(group);
  for (const Index e : x_.t.groups[group].edges.rows()) {
    if (x_.s.request[e].level == nil) continue;
    x_.s.request[e].level = nil;
    arbitration::note_rerequest(x_, e);
  }
}

/// Adds the reasons to run of one of these groups, and calls its start handler if it became live.
void Engine::give_reasons(Index group) {
  const GroupAssignment &now = x_.s.now[group], &last = x_.s.last[group];
  use_data_of(group, now.holder);
  if (x_.s.run_queue[group].flags.has(group_flag::lifecycle)) begin_lifecycle(group);
  std::uint8_t bits = 0;
  const bool handed_on = last.holder != now.holder;
  if (last.active == nil || !last.granted() || handed_on || x_.s.anew[now.holder] != 0) bits |= reason::new_task;
  if (last.active != now.active) bits |= now.in_force() ? reason::pushed : reason::new_task;
  const bool served =
      last.serving() && now.push.provider == last.push.provider && now.push.condition == last.push.condition;
  if (now.serving() && !served) bits |= reason::pushed;
  if (bits != 0) note_reasons(group, bits);
  enter_queue(group);
}

void Engine::adopt_order(Index component) {
  const Component& row = x_.t.components[component];
  const Index count = x_.s.order_count[component] = x_.s.next_count[component];
  const Index* const next = x_.s.next_order + row.order;
  Index* const order = x_.s.order + row.order;
  for (Index i = x_.s.first_moved[component]; i < count; ++i) order[i] = next[i];
}

} // namespace director
