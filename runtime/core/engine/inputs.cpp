// docs/semantics.md, section 3, Inputs: what the outside asks for, sets and fires, what handlers set, and what is due.
// SPDX-License-Identifier: MIT

#include "runtime/core/base/heap_sort.hpp"
#include "runtime/core/engine/notes.hpp"

namespace director {

Engine::Taken Engine::take_posted() {
  Input record;
  return inbox_.take(record) ? take_input(record) : Taken::nothing;
}

/// What is long stands apart, and the call of it is the last thing that is done: so the way to it is short.
Engine::Taken Engine::take_input(Input& record) {
  ++x_.s.counters->micro_step;
  if (observed()) report_input(record);
  return record.kind == Input::Kind::request ? take_request(record) : take_rarer(record);
}

Engine::Taken Engine::take_rarer(Input& record) {
  switch (record.kind) {
  case Input::Kind::request: return take_request(record);
  case Input::Kind::set: return take_states(record);
  case Input::Kind::cancel: return record.thing == nil ? take_cancel_of_all() : take_cancel(record.thing);
  case Input::Kind::fire: return fire(record.thing) ? Taken::change : Taken::no_change;
  case Input::Kind::enable: return take_enabled(record.thing, 1);
  case Input::Kind::disable: return take_enabled(record.thing, 0);
  }
  return Taken::no_change;
}

/// The next record of the same input; the writer published it before the first one.
bool Engine::take_more(Input& record) {
  if (!record.more || !inbox_.take_more(record)) return false;
  if (observed()) report_input(record);
  return true;
}

Engine::Taken Engine::take_request(Input& record) {
  if (bodies_.data != nullptr) return take_request_with_data(record);
  if (record.more || !asks_again(record.thing, record.level)) return take_requests(record);
  give_what_is_asked_again(record.thing);
  return Taken::no_change;
}

[[gnu::noinline]] Engine::Taken Engine::take_request_with_data(Input& record) {
  if (record.more || !asks_again(record.thing, record.level)) return take_requests(record);
  bodies_.data(bodies_.self, Bodies::Data::accept, record.thing, record.handle);
  give_what_is_asked_again(record.thing);
  settle_data(record.thing);
  return Taken::no_change;
}

[[gnu::noinline]] Engine::Taken Engine::take_requests(Input& record) {
  do {
    if (bodies_.data != nullptr) bodies_.data(bodies_.self, Bodies::Data::accept, record.thing, record.handle);
    request(record.thing, record.level);
  } while (take_more(record));
  return Taken::change;
}

[[gnu::noinline]] Engine::Taken Engine::take_states(Input& record) {
  bool changes = false;
  do changes = set_value(record.thing, record.value) || changes;
  while (take_more(record));
  return changes ? Taken::change : Taken::no_change;
}

[[gnu::noinline]] Engine::Taken Engine::take_cancel(Index edge) {
  if (x_.s.request[edge].level == nil) return Taken::no_change;
  withdraw(edge);
  return Taken::change;
}

[[gnu::noinline]] Engine::Taken Engine::take_cancel_of_all() {
  Taken taken = Taken::no_change;
  for (Index edge = 0; edge < x_.t.root_edges; ++edge) {
    if (take_cancel(edge) == Taken::change) taken = Taken::change;
  }
  return taken;
}

[[gnu::noinline]] Engine::Taken Engine::take_enabled(Index provider, std::uint8_t wanted) {
  if (x_.s.enabled[provider] == wanted) return Taken::no_change;
  x_.s.enabled[provider] = wanted;
  if (injected(Fault::enabling_is_overlooked)) return Taken::change;
  const Index component = x_.t.groups[x_.t.providers[provider].group].component;
  mark(component, work::changed);
  x_.s.news_count[component] = nil; // who may push it is not noted, and this is rare
  return Taken::change;
}

/// What start and stop handlers set during one act, merged into one input.
Engine::Taken Engine::take_handlers_input() {
  Counters& c = *x_.s.counters;
  ++c.micro_step;
  c.handlers_set = false;
  bool changes = false;
  const std::span<Index> states{x_.s.handled, c.handled_count};
  c.handled_count = 0;
  heap_sort(states, [](Index a, Index b) { return a < b; });
  for (const Index state : states) {
    const std::int32_t value = x_.s.handler_values[state];
    x_.s.handler_values[state] = unset;
    if (value == unset || !set_value(state, value)) continue;
    changes = true;
    if (observed()) report_set(state);
  }
  return changes ? Taken::change : Taken::no_change;
}

void Engine::set_by_handler(Index state, std::int32_t value) {
  Counters& c = *x_.s.counters;
  c.handlers_set = true;
  std::int32_t& merged = x_.s.handler_values[state];
  if (merged == unset && value != unset) x_.s.handled[c.handled_count++] = state;
  merged = value;
}

/// True if somebody listens.
bool Engine::fire(Index trigger) {
  bool heard = false;
  for (const Index provider : x_.t.list(x_.t.triggers[trigger].listeners)) {
    const Index group = x_.t.providers[provider].group;
    if (x_.s.last[group].active != provider) continue;
    add_reason(group, Reason::trigger);
    const Range listens = x_.t.groups[group].listens;
    for (Index slot = listens.begin; slot != listens.end; ++slot) {
      if (x_.t.listened[slot] == trigger) x_.s.fired[slot] = 1;
    }
    heard = true;
  }
  return heard;
}

/// What is due at the time being served, which began with the earliest: states that expire, waits, promises, `every`,
/// each in order of declaration. Each is an input of its own. What one of them cancels is not due any more when its
/// turn comes.
Engine::Taken Engine::take_timer() {
  Counters& c = *x_.s.counters;
  const Time when = c.next_due;
  if (when > c.now) {
    c.serving = false;
    return Taken::nothing;
  }
  const Timers::Timer timer = timers_.take_first();
  ++c.micro_step;
  if (observed()) report_timer(timer);
  return serve(timer, when) ? Taken::change : Taken::no_change;
}

/// True if that is an input with an effect.
bool Engine::serve(Timers::Timer timer, Time when) {
  const Counters& c = *x_.s.counters;
  const Index row = timer.row;
  switch (timer.kind) {
  case Timers::Kind::expiry: return expire(row);
  case Timers::Kind::promise: return break_promise(row);
  case Timers::Kind::wait: add_reason(row, Reason::wait); break;
  case Timers::Kind::every: {
    const Time period = x_.t.providers[x_.s.last[row].active].every;
    // One that is late runs once, and is due again at the first multiple after it. Two times may be further apart than
    // a Time can say.
    const auto late = static_cast<std::uint64_t>(c.until) - static_cast<std::uint64_t>(when);
    const auto each = static_cast<std::uint64_t>(period);
    timers_.arm({Timers::Kind::every, row}, later(late < each ? when : c.until - static_cast<Time>(late % each), period));
    add_reason(row, Reason::trigger);
    break;
  }
  }
  return true;
}

bool Engine::expire(Index state) {
  if (!assign(state, x_.t.states[state].expires_to)) return false;
  if (observed()) report_set(state);
  return true;
}

/// Once for a push: the other promises of this run of it are over too. True if somebody listens.
bool Engine::break_promise(Index promise) {
  const Index provider = x_.t.promises[promise].provider;
  const Range all = x_.t.providers[provider].promises;
  for (Index i = all.begin; i != all.end; ++i) timers_.disarm({Timers::Kind::promise, i});
  report(Event::Kind::broken, x_.t.providers[provider].group, provider);
  const Index trigger = x_.t.promises[promise].trigger;
  return trigger != nil && fire(trigger);
}

namespace {
/// Whether the condition holds at the value; the interval around the value becomes smaller, so that none of the
/// condition's bounds cuts it.
inline bool narrow(UnchangedInterval& unchanged, std::span<const Interval> accepted, std::int32_t value) {
  bool holds = false;
  for (const Interval& row : accepted) {
    if (row.low > value) {
      if (row.low - 1 < unchanged.high) unchanged.high = row.low - 1;
    } else if (row.high < value) {
      if (row.high + 1 > unchanged.low) unchanged.low = row.high + 1;
    } else {
      holds = true;
      if (row.low > unchanged.low) unchanged.low = row.low;
      if (row.high < unchanged.high) unchanged.high = row.high;
    }
  }
  return holds;
}
} // namespace

/// The state has another value. Components in which a condition flips have to decide again, unless nothing has begun.
/// Without a value nothing is true, and nothing stays unchanged but at that number, which no value has.
void Engine::look_at_conditions(Index state) {
  const std::int32_t value = x_.s.values[state].value;
  UnchangedInterval unchanged{unset + 1, 2147483647};
  if (value == unset) unchanged = {unset, unset};
  for (const Index condition : x_.t.list(x_.t.states[state].conditions)) {
    const Condition& row = x_.t.conditions[condition];
    const bool now = value != unset && narrow(unchanged, x_.t.intervals.subspan(row.accepts.begin, row.accepts.size()), value);
    if (now == arbitration::holds(x_, condition)) continue;
    x_.s.truth[condition] = now ? 1 : 0;
    if (!x_.s.counters->begun || injected(Fault::conditions_are_overlooked)) continue;
    for (const Index component : x_.t.list(row.components)) mark(component, work::changed);
    for (const Index group : x_.t.list(row.groups)) arbitration::touch_group(x_, group);
  }
  x_.s.values[state].unchanged = unchanged;
}

} // namespace director
