// Door: runtime/core/engine/engine.hpp. Test: tests/runtime/core/engine/engine_test.cpp.
// SPDX-License-Identifier: MIT
//
// After every micro-step: arbitrate, and act. Arbitration is a pass, but only over the components whose
// result can be another one than the last: those with a changed input, those whose last pass may decide differently on
// its own result, and those in which it counts whose orders are outdated, when that has changed (see arbitration.hpp).
// Everything else stays as it is, and only groups that gained a reason to run have to be looked at.

#include "runtime/core/engine/notes.hpp"

namespace director {

void Engine::arbitrate() {
  Counters& c = *s_.counters;
  forget_work();
  const Index passes = c.work_count;
  bool stops = false;
  differing_ = 0;
  for (Index i = 0; i < passes; ++i) {
    const Index component = s_.work[i];
    if (observed()) remember_queued(component);
    ++passes_;
    decide(component);
    const bool other = changed(component, stops);
    end_trail();
    std::uint8_t left = depends_on_stale() ? work::stale_counts : 0;
    if (other && (depends_on_last() || depends_on_stale())) left |= work::unsettled;
    s_.component[component] = left | work::listed | work::passed;
  }
  act(passes, stops);
  forget_work();
}

/// Is the new assignment another one? In what the page calls a change (holders, providers, who is granted, pushes), it
/// is arbitrated once more at rest. `stops`: a group is not live any more.
bool Engine::changed(Index component, bool& stops) {
  const Index before = differing_;
  const bool plans = alternatives(component);
  bool decision = false;
  for (const Index g : opened()) {
    const GroupAssignment &now = s_.now[g], &last = s_.last[g];
    if (now.same(last) && !(plans && other_plan(g))) continue;
    s_.group_marks[g] |= mark::differs;
    s_.group_trail[g] |= trail::disturbed;
    s_.differing[differing_++] = g;
    decision = decision || now.decides_otherwise_than(last);
    stops = stops || now.stops_after(last);
  }
  if (decision) s_.counters->unsettled = true;
  return differing_ != before;
}

bool Engine::other_plan(Index group) const {
  const Range slots = t_.groups[group].slots;
  bool other = false;
  for (Index slot = slots.begin; slot != slots.end; ++slot) other = other || s_.now.plan[slot] != s_.last.plan[slot];
  return other;
}

/// What only an observer wants to know: why everything was queued before.
void Engine::remember_queued(Index component) {
  for (const Index e : t_.list(t_.components[component].edges)) s_.last_queued[e] = s_.queued[e];
}

} // namespace director
