// Door: runtime/core/engine.hpp. Test: tests/runtime/core/engine_test.cpp.
//
// Section 3: micro-steps. One loop takes them in the order of choice: what handlers set, the oldest input, what is due
// at the time being served, the oldest run, one more arbitration; then the next due time.

#include "runtime/core/notes.hpp"

namespace director {

/// From the first step on, values expire.
void Engine::take_first_step(Time now) {
  s_.counters->begun = true;
  s_.counters->until = now;
  for (Index i = 0; i < t_.states.size(); ++i) {
    if (t_.states[i].expires != 0 && s_.values[i] != unset) arm(Due::expiry, i, now + t_.states[i].expires);
  }
}

/// False: nothing is left to do up to the time given to `step`.
DIRECTOR_INLINE bool Engine::micro_step() {
  Counters& c = *s_.counters;
  for (;;) {
    if (c.handlers_set) return take_handlers_input(), true;
    if (first_waits_) {
      first_waits_ = false;
      return take_input(first_), true;
    }
    if (inbox_.due() && take_posted()) return true;
    if (c.serving && take_timer()) return true;
    if (c.queue_first != nil) return run_next(), true;
    if (c.unsettled) {
      ++c.micro_step;
      end_micro_step();
      return true;
    }
    const Time due = next_due();
    if (due > c.until) return false;
    c.now = due;
    c.serving = true;
  }
}

StepResult Engine::take_step(Time now) {
  if (inside_) return StepResult::refused;
  Counters& c = *s_.counters;
  if (!c.begun) take_first_step(now);
  c.quiet_until = first_time;
  // Called again for the same time because the budget ran out: what was begun goes on at its own time.
  const bool again = now <= c.until && (c.handlers_set || c.queue_first != nil || c.unsettled);
  if (now > c.until) c.until = now;
  if (!c.serving && !again) c.now = c.until;
  inbox_.open();
  for (std::uint32_t left = budget_; left != 0; --left) {
    if (!micro_step()) return come_to_rest();
    if (!faulted_) continue;
    faulted_ = false;
    return StepResult::fault;
  }
  if (!work_left()) return come_to_rest(); // the budget may end together with what is due
  report(Event::Kind::exhausted);
  return StepResult::budget_exhausted;
}

StepResult Engine::come_to_rest() {
  Counters& c = *s_.counters;
  c.serving = false;
  c.now = c.until;
  c.quiet_until = c.next_due;
  return StepResult::quiescent;
}

bool Engine::work_left() const {
  const Counters& c = *s_.counters;
  return c.handlers_set || c.queue_first != nil || c.unsettled || first_waits_ || inbox_.due() || next_due() <= c.until;
}

} // namespace director
