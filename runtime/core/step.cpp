// Door: runtime/core/engine.hpp. Test: tests/runtime/core/engine_test.cpp.
//
// Section 3: micro-steps. One loop takes them in the order of choice: what handlers set, the oldest input, what is due
// at the time being served, the oldest run, one more arbitration; then the next due time.

#include "runtime/core/arbitration.hpp"
#include "runtime/core/engine.hpp"
#include "runtime/core/marks.hpp"

namespace director {

StepResult Engine::step(Time now) {
  if (inside_) return StepResult::refused;
  Counters& c = *s_.counters;
  if (c.begun == 0) {
    c.begun = 1;
    c.until = now;
    for (Index i = 0; i < t_.states.size(); ++i) {
      if (t_.states[i].expires != 0 && s_.values[i] != unset) s_.expiry[i] = now + t_.states[i].expires;
    }
  }
  if (now > c.until) c.until = now;
  if (c.due_phase == due::none) c.now = c.until;
  quota_ = inbox_.waiting();
  for (std::uint32_t taken = 0;; ++taken) {
    const bool more = taken < budget_;
    if (more ? !micro_step() : !work_left()) return StepResult::quiescent;
    if (!more) {
      tell(event(Event::Kind::exhausted));
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
  return c.handlers_set != 0 || c.queue_count != 0 || c.unsettled != 0 || (quota_ != 0 && !inbox_.empty()) ||
         next_due() <= c.until;
}

/// False: nothing is left to do up to the time given to `step`.
bool Engine::micro_step() {
  Counters& c = *s_.counters;
  for (;;) {
    if (c.handlers_set != 0) return take_handlers_input(), true;
    if (quota_ != 0 && take_input()) return true;
    if (c.due_phase != due::none && take_timer()) return true;
    if (c.queue_count != 0) return run_next(), true;
    if (c.unsettled != 0) {
      ++c.micro_step;
      end_micro_step();
      return true;
    }
    const Time next = next_due();
    if (next > c.until) {
      c.now = c.until;
      return false;
    }
    c.now = next;
    c.due_phase = c.due_at = 0;
  }
}

// Inputs

bool Engine::take_input() {
  Input record;
  if (!inbox_.take(record)) {
    quota_ = 0;
    return false;
  }
  --quota_;
  ++s_.counters->micro_step;
  if (observed()) report_input(record);
  switch (record.kind) {
  case Input::Kind::request: take_request(record); break;
  case Input::Kind::set: take_states(record); break;
  case Input::Kind::cancel:
    if (s_.request[record.thing] == nil) break;
    s_.request[record.thing] = nil;
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
    end_micro_step();
    break;
  }
  }
  return true;
}

/// The next record of the same input; the writer published it before the first one.
bool Engine::take_more(Input& record) {
  if (!record.more || !inbox_.take(record)) return false;
  --quota_;
  if (observed()) report_input(record);
  return true;
}

void Engine::take_request(Input record) {
  anew_ = {0, t_.root_edges};
  do {
    if (bodies_.data != nullptr) bodies_.data(bodies_.self, Bodies::Data::accept, record.thing, record.handle);
    request(record.thing, record.level);
    s_.anew[record.thing] = 1; // the same root task requested again is a new task, as in a pack
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
  for (Index i = 0; i < t_.states.size(); ++i) {
    const std::int32_t value = s_.handler_values[i];
    if (value == unset) continue;
    s_.handler_values[i] = unset;
    if (s_.values[i] != value) report_set(i, value);
    changes = set_value(i, value) || changes;
  }
  if (changes) end_micro_step();
}

void Engine::request(Index edge, Index level) {
  if (s_.request[edge] != level) s_.stamp[edge] = s_.counters->micro_step;
  s_.request[edge] = level;
}

/// True if the value changes. What expires counts anew, also where it does not.
bool Engine::set_value(Index state, std::int32_t value) {
  const Time expires = t_.states[state].expires;
  if (expires != 0) s_.expiry[state] = s_.counters->now + expires;
  if (s_.values[state] == value) return false;
  s_.values[state] = value;
  return true;
}

/// True if somebody listens.
bool Engine::fire(Index trigger) {
  bool heard = false;
  for (const Index provider : t_.list(t_.triggers[trigger].listeners)) {
    const Index group = t_.providers[provider].group;
    if (s_.last.active[group] != provider) continue;
    add_reason(group, Reason::trigger);
    const Range listens = t_.groups[group].listens;
    for (Index slot = listens.begin; slot != listens.end; ++slot) {
      if (t_.listened[slot] == trigger) s_.fired[slot] = 1;
    }
    heard = true;
  }
  return heard;
}

// Time

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
  const auto take = [&](Time* times, Index at) {
    ++c.micro_step;
    times[at] = never;
    if (!observed()) return;
    constexpr Event::Input kinds[] = {Event::Input::expire, Event::Input::wait, Event::Input::within,
                                      Event::Input::every};
    Event input = event(Event::Kind::input, c.due_phase == due::expiry ? nil : at);
    input.input = kinds[c.due_phase];
    if (c.due_phase == due::expiry) input.state = at;
    if (c.due_phase == due::promise) {
      input.provider = t_.promises[at].provider;
      input.group = t_.providers[input.provider].group;
    }
    tell(input);
  };
  for (; c.due_phase != due::none; ++c.due_phase, c.due_at = 0) {
    Time* const times = c.due_phase == due::expiry    ? s_.expiry
                        : c.due_phase == due::wait    ? s_.wait
                        : c.due_phase == due::promise ? s_.promise_due
                                                      : s_.every;
    const std::size_t count = c.due_phase == due::expiry    ? t_.states.size()
                              : c.due_phase == due::promise ? t_.promises.size()
                                                            : t_.groups.size();
    while (c.due_at < count) {
      const Index at = c.due_at++;
      const Time when = times[at];
      if (when > c.now) continue;
      take(times, at);
      bool changes = true;
      switch (c.due_phase) {
      case due::expiry: changes = expire(at); break;
      case due::promise: changes = break_promise(at); break;
      case due::wait: add_reason(at, Reason::wait); break;
      default: {
        const Time period = t_.providers[s_.last.active[at]].every;
        Time next = when + period; // one that is late runs once
        if (next <= c.until) next += ((c.until - next) / period + 1) * period;
        s_.every[at] = next;
        add_reason(at, Reason::trigger);
        break;
      }
      }
      if (changes) end_micro_step();
      return true;
    }
  }
  return false;
}

bool Engine::expire(Index state) {
  const std::int32_t to = t_.states[state].expires_to;
  if (s_.values[state] == to) return false;
  s_.values[state] = to;
  report_set(state, to);
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

// A run

void Engine::run_next() {
  Counters& c = *s_.counters;
  ++c.micro_step;
  const Index group = s_.queue[0];
  --c.queue_count;
  for (Index i = 0; i < c.queue_count; ++i) s_.queue[i] = s_.queue[i + 1];
  s_.in_queue[group] = 0;
  std::uint8_t reasons = s_.pending[group];
  s_.pending[group] = 0;
  if (!in_force(group)) reasons &= static_cast<std::uint8_t>(~static_cast<std::uint8_t>(Reason::pushed));
  if (reasons == 0) return end_micro_step(); // nobody pushes it any more

  const Index provider = s_.last.active[group];
  if (in_force(group) && s_.promised_provider[group] == nil) { // section 7: its first run on that push
    s_.promised_edge[group] = s_.last.push[group].edge;
    s_.promised_provider[group] = provider;
    const Range promises = t_.providers[provider].promises;
    for (Index i = promises.begin; i != promises.end; ++i) s_.promise_due[i] = c.now + t_.promises[i].within;
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
  end_micro_step();
}

/// Everything that a run asked for, together.
void Engine::commit(const Run& run, Outcome::Kind kind) {
  const Index group = run.group_;
  const Range listens = t_.groups[group].listens, edges = t_.groups[group].edges;
  for (Index slot = listens.begin; slot != listens.end; ++slot) s_.fired[slot] = 0;
  const bool fault = kind == Outcome::Kind::fault;
  for (Index i = 0; i < t_.states.size(); ++i) {
    const std::int32_t value = s_.staged_value[i];
    if (value == unset) continue;
    s_.staged_value[i] = unset;
    if (fault) continue;
    const bool changes = s_.values[i] != value;
    set_value(i, value);
    if (changes) report_set(i, value);
  }
  if (kind == Outcome::Kind::pack) {
    commit_pack(edges);
    s_.done[group] = 0;
  } else if ((kind == Outcome::Kind::done || kind == Outcome::Kind::failed) && s_.done[group] == 0) {
    answer(group, kind == Outcome::Kind::failed);
  }
  for (Index i = 0; i < edges.size(); ++i) s_.staged_level[i] = nil;
  if (fault) {
    Event fault_event = event(Event::Kind::fault, group);
    fault_event.provider = run.provider_;
    tell(fault_event);
    faulted_ = true;
  } else if (run.wait_ > 0) {
    s_.wait[group] = s_.counters->now + run.wait_;
  } else if (kind == Outcome::Kind::pack) {
    s_.wait[group] = never;
  }
}

void Engine::commit_pack(Range edges) {
  anew_ = edges;
  for (Index e = edges.begin; e != edges.end; ++e) {
    const auto at = static_cast<Index>(e - edges.begin);
    if (s_.staged_level[at] == nil) {
      s_.request[e] = nil;
    } else if (s_.staged_keep[at] == 0) {
      request(e, s_.staged_level[at]);
      s_.anew[e] = 1;
    }
  }
}

void Engine::answer(Index group, bool failed) {
  s_.done[group] = failed ? result::done | result::failed : result::done;
  tell(event(failed ? Event::Kind::failed : Event::Kind::done, group));
  const Index holder = s_.last.holder[group], requester = t_.edges[holder].requester;
  if (requester == nil) {
    s_.request[holder] = nil;
  } else {
    add_reason(requester, Reason::subtask_done);
  }
}

void Engine::end_micro_step() {
  Pass pass(t_, s_);
  pass.arbitrate();
  act({s_.next_order, pass.order_count()});
}

void Engine::report_set(Index state, std::int32_t value) {
  if (!observed()) return;
  Event set = event(Event::Kind::set);
  set.state = state;
  set.value = value;
  tell(set);
}

void Engine::report_input(const Input& record) const {
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
