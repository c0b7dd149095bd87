// Door: runtime/core/engine.hpp. Test: tests/runtime/core/engine_test.cpp.
//
// Section 3, Time. What is due is found by looking at all timers, but only when the earliest is due: `earliest` may be
// too early (what was cancelled is not taken out of it), never too late.

#include "runtime/core/engine.hpp"
#include "runtime/core/marks.hpp"

namespace director {

void Engine::arm(Time& timer, Time due) {
  timer = due;
  if (due < s_.counters->earliest) s_.counters->earliest = due;
}

Time Engine::next_due() const {
  Time next = never;
  const auto least = [&](const Time* times, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) next = times[i] < next ? times[i] : next;
  };
  least(s_.expiry, t_.states.size());
  least(s_.wait, t_.groups.size());
  least(s_.promise_due, t_.promises.size());
  least(s_.every, t_.groups.size());
  return next;
}

/// What is due at the time being served: states that expire, waits, promises, `every`, each in order of declaration.
/// Each is an input of its own. What one of them cancels is not due any more when its turn comes.
bool Engine::take_timer() {
  Counters& c = *s_.counters;
  for (; c.due_phase != due::none; ++c.due_phase, c.due_at = 0) {
    Time* const timers[] = {s_.expiry, s_.wait, s_.promise_due, s_.every};
    const std::size_t counts[] = {t_.states.size(), t_.groups.size(), t_.promises.size(), t_.groups.size()};
    while (c.due_at < counts[c.due_phase]) {
      const Index row = c.due_at++;
      const Time when = timers[c.due_phase][row];
      if (when > c.now) continue;
      timers[c.due_phase][row] = never;
      ++c.micro_step;
      if (observed()) report_timer(row);
      if (serve_timer(row, when)) end_micro_step();
      return true;
    }
  }
  return false;
}

/// True if that is an input with an effect.
bool Engine::serve_timer(Index row, Time when) {
  const Counters& c = *s_.counters;
  switch (c.due_phase) {
  case due::expiry: return expire(row);
  case due::promise: return break_promise(row);
  case due::wait: add_reason(row, Reason::wait); return true;
  default: {
    const Time period = t_.providers[s_.last.active[row]].every;
    Time next = when + period; // one that is late runs once
    if (next <= c.until) next += ((c.until - next) / period + 1) * period;
    arm(s_.every[row], next);
    add_reason(row, Reason::trigger);
    return true;
  }
  }
}

bool Engine::expire(Index state) {
  if (!assign(state, t_.states[state].expires_to)) return false;
  report_set(state);
  return true;
}

/// Once for a push: the other promises of this run of it are over too. True if somebody listens.
bool Engine::break_promise(Index promise) {
  const Index provider = t_.promises[promise].provider;
  const Range all = t_.providers[provider].promises;
  for (Index i = all.begin; i != all.end; ++i) s_.promise_due[i] = never;
  Event broken = event(Event::Kind::broken, t_.providers[provider].group);
  broken.provider = provider;
  tell(broken);
  const Index trigger = t_.promises[promise].trigger;
  return trigger != nil && fire(trigger);
}

void Engine::report_timer(Index row) const {
  constexpr Event::Input kinds[] = {Event::Input::expire, Event::Input::wait, Event::Input::within,
                                    Event::Input::every};
  const Index phase = s_.counters->due_phase;
  Event input = event(Event::Kind::input);
  input.input = kinds[phase];
  if (phase == due::expiry) {
    input.state = row;
  } else if (phase == due::promise) {
    input.provider = t_.promises[row].provider;
    input.group = t_.providers[input.provider].group;
  } else {
    input.group = row;
  }
  tell(input);
}

} // namespace director
