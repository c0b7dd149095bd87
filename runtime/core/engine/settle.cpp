// docs/semantics.md, section 3: after every micro-step, arbitrate and act.
// SPDX-License-Identifier: MIT
//
// Arbitration is a pass, but only over the components whose
// result can be another one than the last: those with a changed input, those whose last pass may decide differently on
// its own result, and those in which it counts whose orders are outdated, when that has changed (pass.hpp).
// Everything else stays as it is, and only groups that gained a reason to run have to be looked at.

#include "runtime/core/arbitration/choices.hpp"
#include "runtime/core/engine/notes.hpp"

namespace director {

void Engine::arbitrate() {
  Counters& c = *x_.s.counters;
  forget_work();
  const Index passes = c.work_count;
  bool stops = false;
  differing_ = 0;
  for (Index i = 0; i < passes; ++i) {
    const Index component = x_.s.work[i];
    if (observed()) remember_queued(component);
    ++passes_;
    arbitration::decide(x_, component);
    const bool other = changed(component, stops);
    arbitration::end(x_);
    std::uint8_t left = x_.depends_on_all_stale ? work::stale_counts : 0;
    if (other && (x_.depends_on_last || x_.depends_on_stale)) left |= work::unsettled;
    x_.s.component[component] = left | work::listed | work::passed;
  }
  act(passes, stops);
  forget_work();
}

/// Is the new assignment another one? In what the page calls a change (holders, providers, who is granted, pushes), it
/// is arbitrated once more at rest. `stops`: a group is not live any more.
bool Engine::changed(Index component, bool& stops) {
  const Index before = differing_;
  const bool plans = arbitration::alternatives(x_, component);
  bool decision = false;
  for (const Index g : arbitration::opened(x_)) {
    const GroupAssignment &now = x_.s.now[g], &last = x_.s.last[g];
    if (now == last && !(plans && other_plan(g))) continue;
    x_.s.group_marks[g] |= mark::differs;
    x_.s.group_trail[g] |= trail::disturbed;
    x_.s.differing[differing_++] = g;
    decision = decision || now.decides_otherwise_than(last);
    stops = stops || now.stops_after(last);
  }
  if (decision) x_.s.counters->unsettled = true;
  return differing_ != before;
}

} // namespace director
