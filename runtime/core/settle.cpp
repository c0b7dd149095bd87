// Door: runtime/core/engine.hpp. Test: tests/runtime/core/engine_test.cpp.
//
// After every micro-step: arbitrate, and act. Arbitration is a pass from nothing, but only over the components whose
// result can be another one than the last: those with a changed input, those whose last pass may decide differently on
// its own result, and those in which it counts whose orders are outdated, when that has changed (see arbitration.hpp).
// Everything else stays as it is, and only groups that gained a reason to run have to be looked at.

#include "runtime/core/arbitration.hpp"
#include "runtime/core/engine.hpp"
#include "runtime/core/marks.hpp"

namespace director {

namespace {
bool needs_pass(std::uint8_t bits) {
  constexpr std::uint8_t outdated = work::stale_counts | work::stale_changed;
  return (bits & (work::changed | work::unsettled)) != 0 || (bits & outdated) == outdated;
}
} // namespace

void Engine::mark(Index component, std::uint8_t bits) {
  std::uint8_t& all = s_.component[component];
  all |= bits;
  if ((all & work::listed) != 0) return;
  all |= work::listed;
  s_.work[s_.counters->work_count++] = component;
}

void Engine::touch(Index group) {
  if ((s_.in_queue[group] & place::touched) != 0) return;
  s_.in_queue[group] |= place::touched;
  s_.touched[s_.counters->touched_count++] = group;
}

void Engine::add_reason(Index group, Reason reason) {
  const auto bit = static_cast<std::uint8_t>(reason);
  if (reason == Reason::new_task) s_.done[group] = 0;
  if ((s_.pending[group] & bit) != 0) return;
  s_.pending[group] |= bit;
  touch(group);
  const Index component = t_.groups[group].component;
  if ((reason == Reason::new_task || reason == Reason::pushed) && (s_.component[component] & work::stale_counts) != 0)
    mark(component, work::stale_changed);
}

void Engine::end_micro_step() {
  Counters& c = *s_.counters;
  c.unsettled = 0;
  if (c.work_count == 0) return act_on_touched();
  forget_work();
  const Index passes = c.work_count;
  for (Index i = 0; i < passes; ++i) {
    const Index component = s_.work[i];
    Pass pass(t_, s_, component);
    pass.arbitrate();
    bool decision = false;
    const bool other = changed(component, decision);
    if (decision) c.unsettled = 1;
    std::uint8_t bits = work::listed;
    if (pass.depends_on_stale()) bits |= work::stale_counts;
    if (other && (pass.depends_on_last() || pass.depends_on_stale())) bits |= work::unsettled;
    s_.component[component] = bits;
  }
  act(passes);
  forget_work();
}

/// Leaves in State::work what the next arbitration has to look at.
void Engine::forget_work() {
  Counters& c = *s_.counters;
  Index left = 0;
  for (Index i = 0; i < c.work_count; ++i) {
    const Index component = s_.work[i];
    if (needs_pass(s_.component[component])) {
      s_.work[left++] = component;
    } else {
      s_.component[component] &= work::stale_counts;
    }
  }
  c.work_count = left;
}

/// Is the new assignment another one? `decision`: in what the page calls a change (holders, providers, who is granted,
/// pushes), so that at rest it is arbitrated once more.
bool Engine::changed(Index component, bool& decision) const {
  bool other = false;
  for (const Index g : t_.list(t_.components[component].groups)) {
    const Assignment &now = s_.now, &last = s_.last;
    decision = decision || now.holder[g] != last.holder[g] || now.active[g] != last.active[g] ||
               ((now.flags[g] ^ last.flags[g]) & flag::granted) != 0 || now.push[g] != last.push[g];
    other =
        other || now.flags[g] != last.flags[g] || now.planned[g] != last.planned[g] || now.serves[g] != last.serves[g];
    const Range slots = t_.groups[g].slots;
    for (Index slot = slots.begin; slot != slots.end; ++slot) other = other || now.plan[slot] != last.plan[slot];
  }
  return other || decision;
}

} // namespace director
