// Door: runtime/core/engine.hpp. Test: tests/runtime/core/engine_test.cpp.
//
// Section 3: micro-steps. One loop takes them in the order of choice: what handlers set, the oldest input, what is due
// at the time being served, the oldest run, one more arbitration; then the next due time.

#include "runtime/core/heap_sort.hpp"
#include "runtime/core/notes.hpp"

namespace director {

/// From the first step on, values expire.
void Engine::take_first_step(Time now) {
  s_.counters->begun = 1;
  s_.counters->until = now;
  for (Index i = 0; i < t_.states.size(); ++i) {
    if (t_.states[i].expires != 0 && s_.values[i] != unset) arm(Due::expiry, i, now + t_.states[i].expires);
  }
}

StepResult Engine::take_step(Time now) {
  if (inside_) return StepResult::refused;
  Counters& c = *s_.counters;
  if (c.begun == 0) take_first_step(now);
  c.quiet_until = first_time;
  // Called again for the same time because the budget ran out: what was begun goes on at its own time.
  const bool again = now <= c.until && (c.handlers_set != 0 || c.queue_first != nil || c.unsettled != 0);
  if (now > c.until) c.until = now;
  if (c.serving == 0 && !again) c.now = c.until;
  inbox_.open();
  for (std::uint32_t taken = 0;; ++taken) {
    const bool more = taken < budget_;
    if (more ? !micro_step() : !work_left()) {
      c.serving = 0; // the budget may end together with what is due
      c.now = c.until;
      c.quiet_until = next_due();
      return StepResult::quiescent;
    }
    if (!more) {
      report(Event::Kind::exhausted);
      return StepResult::budget_exhausted;
    }
    if (faulted_) {
      faulted_ = false;
      return StepResult::fault;
    }
  }
}

bool Engine::work_left() const {
  const Counters& c = *s_.counters;
  return c.handlers_set != 0 || c.queue_first != nil || c.unsettled != 0 || inbox_.due() || next_due() <= c.until;
}

/// False: nothing is left to do up to the time given to `step`.
bool Engine::micro_step() {
  Counters& c = *s_.counters;
  for (;;) {
    if (c.handlers_set != 0) return take_handlers_input(), true;
    if (inbox_.due() && take_input()) return true;
    if (c.serving != 0 && take_timer()) return true;
    if (c.queue_first != nil) return run_next(), true;
    if (c.unsettled != 0) {
      ++c.micro_step;
      end_micro_step();
      return true;
    }
    const Time due = next_due();
    if (due > c.until) return false;
    c.now = due;
    c.serving = 1;
  }
}

// Inputs

bool Engine::take_input() {
  Input record;
  if (!inbox_.take(record)) return false;
  ++s_.counters->micro_step;
  if (observed()) report_input(record);
  switch (record.kind) {
  case Input::Kind::request: take_request(record); break;
  case Input::Kind::set: take_states(record); break;
  case Input::Kind::cancel:
    if (s_.request[record.thing] == nil) break;
    withdraw(record.thing);
    end_micro_step();
    break;
  case Input::Kind::fire:
    if (fire(record.thing)) end_micro_step();
    break;
  case Input::Kind::enable:
  case Input::Kind::disable: {
    const std::uint8_t wanted = record.kind == Input::Kind::enable ? 1 : 0;
    if (s_.enabled[record.thing] == wanted) break;
    s_.enabled[record.thing] = wanted;
    mark(t_.groups[t_.providers[record.thing].group].component, work::changed);
    end_micro_step();
    break;
  }
  }
  return true;
}

/// The next record of the same input; the writer published it before the first one.
bool Engine::take_more(Input& record) {
  if (!record.more || !inbox_.take_more(record)) return false;
  if (observed()) report_input(record);
  return true;
}

void Engine::take_request(Input record) {
  do {
    if (bodies_.data != nullptr) bodies_.data(bodies_.self, Bodies::Data::accept, record.thing, record.handle);
    request(record.thing, record.level);
  } while (take_more(record));
  end_micro_step();
}

void Engine::take_states(Input record) {
  bool changes = false;
  do changes = set_value(record.thing, record.value) || changes;
  while (take_more(record));
  if (changes) end_micro_step();
}

/// What start and stop handlers set during one act, merged into one input.
void Engine::take_handlers_input() {
  Counters& c = *s_.counters;
  ++c.micro_step;
  c.handlers_set = 0;
  bool changes = false;
  const std::span<Index> states{s_.handled, c.handled_count};
  c.handled_count = 0;
  heap_sort(states, [](Index a, Index b) { return a < b; });
  for (const Index state : states) {
    const std::int32_t value = s_.handler_values[state];
    s_.handler_values[state] = unset;
    if (value == unset || !set_value(state, value)) continue;
    changes = true;
    report_set(state);
  }
  if (changes) end_micro_step();
}

void Engine::set_by_handler(Index state, std::int32_t value) {
  Counters& c = *s_.counters;
  c.handlers_set = 1;
  std::int32_t& merged = s_.handler_values[state];
  if (merged == unset && value != unset) s_.handled[c.handled_count++] = state;
  merged = value;
}

void Engine::request(Index edge, Index level) {
  if (s_.anew[edge] == 0) s_.asked[s_.counters->asked_count++] = edge;
  s_.anew[edge] = 1; // the same task requested again is a new task
  const Index group = t_.edges[edge].target;
  if (s_.request[edge] != level) {
    s_.stamp[edge] = s_.counters->micro_step;
    s_.request[edge] = level;
    mark(t_.groups[group].component, work::changed);
  }
  mark_stale(group);
  touch(group);
}

void Engine::withdraw(Index edge) {
  if (s_.request[edge] == nil) return;
  s_.request[edge] = nil;
  mark(t_.groups[t_.edges[edge].target].component, work::changed);
}

/// True if the value changes. What expires counts anew, also where it does not.
bool Engine::set_value(Index state, std::int32_t value) {
  const Time expires = t_.states[state].expires;
  if (expires != 0) arm(Due::expiry, state, s_.counters->now + expires);
  return assign(state, value);
}

/// The components in which a condition flips have to decide again.
bool Engine::assign(Index state, std::int32_t value) {
  const std::int32_t before = s_.values[state];
  if (before == value) return false;
  s_.values[state] = value;
  for (const Index condition : t_.list(t_.states[state].conditions)) {
    const Condition& row = t_.conditions[condition];
    if (accepts(t_, row, before) == accepts(t_, row, value)) continue;
    for (const Index component : t_.list(row.components)) mark(component, work::changed);
  }
  return true;
}

/// True if somebody listens.
bool Engine::fire(Index trigger) {
  bool heard = false;
  for (const Index provider : t_.list(t_.triggers[trigger].listeners)) {
    const Index group = t_.providers[provider].group;
    if (s_.last[group].active != provider) continue;
    add_reason(group, Reason::trigger);
    const Range listens = t_.groups[group].listens;
    for (Index slot = listens.begin; slot != listens.end; ++slot) {
      if (t_.listened[slot] == trigger) s_.fired[slot] = 1;
    }
    heard = true;
  }
  return heard;
}

// A run

void Engine::run_next() {
  Counters& c = *s_.counters;
  ++c.micro_step;
  const Index group = c.queue_first;
  leave_queue(group);
  std::uint8_t reasons = s_.pending[group];
  s_.pending[group] = 0;
  mark_stale(group);
  if (!in_force(group)) reasons &= static_cast<std::uint8_t>(~static_cast<std::uint8_t>(Reason::pushed));
  if (reasons == 0) return end_micro_step(); // nobody pushes it any more

  const Index provider = s_.last[group].active;
  if (in_force(group) && s_.promised_provider[group] == nil) { // section 7: its first run on that push
    s_.promised_edge[group] = s_.last[group].push.edge;
    s_.promised_provider[group] = provider;
    const Range promises = t_.providers[provider].promises;
    for (Index i = promises.begin; i != promises.end; ++i) arm(Due::promise, i, c.now + t_.promises[i].within);
  }
  Run run(*this, group, provider, Reasons{reasons});
  if (observed()) {
    Event running = event(Event::Kind::run, group);
    running.provider = provider;
    running.reasons = run.reasons();
    tell(running);
  }
  inside_ = true;
  const Outcome outcome = bodies_.run[provider](bodies_.self, run);
  inside_ = false;
  commit(run, outcome.kind());
  ran_ = group;
  end_micro_step();
  ran_ = nil;
}

/// Everything that a run asked for, together.
void Engine::commit(const Run& run, Outcome::Kind kind) {
  const Index group = run.group_;
  const Range listens = t_.groups[group].listens, edges = t_.groups[group].edges;
  for (Index slot = listens.begin; slot != listens.end; ++slot) s_.fired[slot] = 0;
  const bool fault = kind == Outcome::Kind::fault;
  for (Index i = 0; i < s_.counters->staged_count; ++i) {
    const Index state = s_.staged[i];
    const std::int32_t value = s_.staged_value[state];
    s_.staged_value[state] = unset;
    if (!fault && set_value(state, value)) report_set(state);
  }
  s_.counters->staged_count = 0;
  if (kind == Outcome::Kind::pack) {
    commit_pack(edges);
    s_.done[group] = 0;
  } else {
    for (Index i = 0; i < edges.size(); ++i) s_.staged_level[i] = nil;
    if ((kind == Outcome::Kind::done || kind == Outcome::Kind::failed) && s_.done[group] == 0)
      answer(group, kind == Outcome::Kind::failed);
  }
  if (fault) {
    if (observed()) {
      Event fault_event = event(Event::Kind::fault, group);
      fault_event.provider = run.provider_;
      tell(fault_event);
    }
    faulted_ = true;
  } else if (run.wait_ > 0) {
    if (observed()) {
      Event wait = event(Event::Kind::wait, group);
      wait.due = s_.counters->now + run.wait_;
      tell(wait);
    }
    arm(Due::wait, group, s_.counters->now + run.wait_);
  } else if (kind == Outcome::Kind::pack) {
    disarm(Due::wait, group);
  }
}

void Engine::commit_pack(Range edges) {
  for (Index e = edges.begin; e != edges.end; ++e) {
    const auto at = static_cast<Index>(e - edges.begin);
    const Index level = s_.staged_level[at];
    s_.staged_level[at] = nil;
    if (level == nil) {
      if (observed() && s_.request[e] != nil) report_request(Event::Kind::withdraw, e);
      withdraw(e);
    } else if (s_.staged_keep[at] == 0) {
      if (observed()) report_request(Event::Kind::ask, e, level);
      request(e, level);
    } else {
      if (observed()) report_request(Event::Kind::keep, e, level);
    }
  }
}

void Engine::answer(Index group, bool failed) {
  s_.done[group] = failed ? result::done | result::failed : result::done;
  report(failed ? Event::Kind::failed : Event::Kind::done, group);
  const Index holder = s_.last[group].holder, requester = t_.edges[holder].requester;
  if (requester == nil) {
    withdraw(holder);
  } else {
    add_reason(requester, Reason::subtask_done);
  }
}

void Engine::report_request(Event::Kind kind, Index edge, Index level) const {
  if (!observed()) return;
  Event request = event(kind, t_.edges[edge].target);
  request.edge = edge;
  request.level = level;
  tell(request);
}

void Engine::report_input(const Input& record) const {
  if (!observed()) return;
  Event input = event(Event::Kind::input);
  constexpr Event::Input kinds[] = {Event::Input::request, Event::Input::cancel, Event::Input::set,
                                    Event::Input::fire,    Event::Input::enable, Event::Input::disable};
  input.input = kinds[static_cast<std::size_t>(record.kind)];
  switch (record.kind) {
  case Input::Kind::request:
  case Input::Kind::cancel:
    input.edge = record.thing;
    input.group = t_.edges[record.thing].target;
    break;
  case Input::Kind::set:
    input.state = record.thing;
    input.value = record.value;
    break;
  case Input::Kind::fire: input.trigger = record.thing; break;
  case Input::Kind::enable:
  case Input::Kind::disable:
    input.provider = record.thing;
    input.group = t_.providers[record.thing].group;
    break;
  }
  tell(input);
}

} // namespace director
