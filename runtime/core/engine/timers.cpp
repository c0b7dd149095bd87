// docs/semantics.md, section 3, Time.
// SPDX-License-Identifier: MIT
//
// Timers are numbered kind by kind, in the order in which those that are due together are served, and
// by declaration. Above them stands a tree: node n knows which one below it is due first, 2n and 2n+1 being the nodes
// below n and the timers its leaves, so that node 1 knows the first of all. Cost: the root is read; a change climbs as
// far as it matters.

#include "runtime/core/engine/notes.hpp"

namespace director {

Index Engine::sooner(std::size_t node) const {
  const Index a = soonest(2 * node), b = soonest(2 * node + 1);
  if (x_.s.due[a] != x_.s.due[b]) return x_.s.due[a] < x_.s.due[b] ? a : b;
  return a < b ? a : b;
}

void Engine::clear_timers() {
  const std::size_t timers = Shape::of(x_.t).timers();
  for (std::size_t i = 0; i < timers; ++i) x_.s.due[i] = never;
  for (std::size_t node = timers; node-- > 1;) x_.s.soonest[node] = sooner(node);
  x_.s.counters->next_due = never;
}

void Engine::set_timer(Index index, Time due) {
  x_.s.due[index] = due;
  for (std::size_t node = (index + Shape::of(x_.t).timers()) / 2; node >= 1; node /= 2) {
    const Index first = sooner(node);
    if (x_.s.soonest[node] == first && first != index) return;
    x_.s.soonest[node] = first;
  }
  x_.s.counters->next_due = x_.s.due[soonest(1)];
}

/// What is due at the time being served, which began with the earliest: states that expire, waits, promises, `every`,
/// each in order of declaration. Each is an input of its own. What one of them cancels is not due any more when its
/// turn comes.
Engine::Taken Engine::take_timer() {
  Counters& c = *x_.s.counters;
  const Time when = next_due();
  if (when > c.now) {
    c.serving = false;
    return Taken::nothing;
  }
  const Index index = soonest(1);
  set_timer(index, never);
  ++c.micro_step;
  Due kind = Due::every; // the last of the kinds that begin at this timer or before
  while (timer(kind, 0) > index) kind = static_cast<Due>(static_cast<std::uint8_t>(kind) - 1);
  const auto row = static_cast<Index>(index - timer(kind, 0));
  if (observed()) report_timer(kind, row);
  return serve_timer(kind, row, when) ? Taken::change : Taken::no_change;
}

/// True if that is an input with an effect.
bool Engine::serve_timer(Due kind, Index row, Time when) {
  const Counters& c = *x_.s.counters;
  switch (kind) {
  case Due::expiry: return expire(row);
  case Due::promise: return break_promise(row);
  case Due::wait: add_reason(row, Reason::wait); break;
  case Due::every: {
    const Time period = x_.t.providers[x_.s.last[row].active].every;
    // One that is late runs once, and is due again at the first multiple after it. Two times may be further apart than
    // a Time can say.
    const auto late = static_cast<std::uint64_t>(c.until) - static_cast<std::uint64_t>(when);
    const auto each = static_cast<std::uint64_t>(period);
    arm(Due::every, row, later(late < each ? when : c.until - static_cast<Time>(late % each), period));
    add_reason(row, Reason::trigger);
    break;
  }
  }
  return true;
}

bool Engine::expire(Index state) {
  if (!assign(state, x_.t.states[state].expires_to)) return false;
  report_set(state);
  return true;
}

/// Once for a push: the other promises of this run of it are over too. True if somebody listens.
bool Engine::break_promise(Index promise) {
  const Index provider = x_.t.promises[promise].provider;
  const Range all = x_.t.providers[provider].promises;
  for (Index i = all.begin; i != all.end; ++i) disarm(Due::promise, i);
  if (observed()) {
    Event broken = event(Event::Kind::broken, x_.t.providers[provider].group);
    broken.provider = provider;
    tell(broken);
  }
  const Index trigger = x_.t.promises[promise].trigger;
  return trigger != nil && fire(trigger);
}

void Engine::report_timer(Due kind, Index row) const {
  if (!observed()) return;
  Event input = event(Event::Kind::input);
  switch (kind) {
  case Due::expiry:
    input.input = Event::Input::expire;
    input.state = row;
    break;
  case Due::wait:
    input.input = Event::Input::wait;
    input.group = row;
    break;
  case Due::promise:
    input.input = Event::Input::within;
    input.provider = x_.t.promises[row].provider;
    input.group = x_.t.providers[input.provider].group;
    break;
  case Due::every:
    input.input = Event::Input::every;
    input.group = row;
    break;
  }
  tell(input);
}

} // namespace director
