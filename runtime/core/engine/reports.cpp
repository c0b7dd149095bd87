// docs/semantics.md, section 6: what an observer is told. Without one nothing of it is linked.
// SPDX-License-Identifier: MIT

#include "runtime/core/engine/engine.hpp"

namespace director {

void Engine::observe(Observer observer) { observer_ = observer; }

void Engine::tell(const Event& event) const {
  const bool inside = inside_;
  inside_ = true;
  observer_.tell(observer_.self, event);
  inside_ = inside;
}

Event Engine::event(Event::Kind kind, Index group) const {
  Event out;
  out.kind = kind;
  out.group = group;
  out.time = x_.s.counters->now;
  out.until = x_.s.counters->until;
  out.micro_step = x_.s.counters->micro_step;
  return out;
}

void Engine::report_run(Event::Kind kind, Index group, Index provider, Reasons reasons) const {
  Event run = event(kind, group);
  run.provider = provider;
  run.reasons = reasons;
  tell(run);
}

void Engine::report_request(Event::Kind kind, Index edge, Index level) const {
  Event request = event(kind, x_.t.edges[edge].target);
  request.edge = edge;
  request.level = level;
  tell(request);
}

void Engine::report_begin() const {
  tell(event(Event::Kind::begin));
  for (Index i = 0; i < x_.t.states.size(); ++i) {
    if (x_.s.values[i].value == x_.t.states[i].initial) continue;
    Event given = event(Event::Kind::given);
    given.state = i;
    given.value = x_.s.values[i].value;
    tell(given);
  }
}

/// And which states the run sets, those among them that have the value already.
void Engine::report_answer(Index group, Index provider, Outcome::Kind outcome, std::uint16_t pack) const {
  Event answer = event(Event::Kind::answer, group);
  answer.provider = provider;
  answer.outcome = outcome;
  if (outcome == Outcome::Kind::pack) answer.pack = pack;
  tell(answer);
  for (Index i = 0; i < x_.s.counters->staged_count && outcome != Outcome::Kind::fault; ++i)
    report_value(Event::Kind::assign, group, provider, x_.s.staged[i], x_.s.values[x_.s.staged[i]].staged);
}

/// What a body or handler sets, or may not set.
void Engine::report_value(Event::Kind kind, Index group, Index provider, Index state, std::int32_t value) const {
  Event set = event(kind, group);
  set.provider = provider;
  set.state = state;
  set.value = value;
  tell(set);
}

void Engine::report_wait(Index group, Time due) const {
  Event wait = event(Event::Kind::wait, group);
  wait.due = due;
  tell(wait);
}

void Engine::report_timer(Timers::Timer timer) const {
  Event input = event(Event::Kind::input);
  const Index row = timer.row;
  switch (timer.kind) {
  case Timers::Kind::expiry:
    input.input = Event::Input::expire;
    input.state = row;
    break;
  case Timers::Kind::wait:
    input.input = Event::Input::wait;
    input.group = row;
    break;
  case Timers::Kind::promise:
    input.input = Event::Input::within;
    input.provider = x_.t.promises[row].provider;
    input.group = x_.t.providers[input.provider].group;
    break;
  case Timers::Kind::every:
    input.input = Event::Input::every;
    input.group = row;
    break;
  }
  tell(input);
}

void Engine::report_set(Index state) const {
  Event set = event(Event::Kind::set);
  set.state = state;
  set.value = x_.s.values[state].value;
  tell(set);
}

/// Since the step before.
void Engine::report_lost() {
  Event lost = event(Event::Kind::lost);
  const std::uint32_t so_far = inbox_.lost();
  lost.count = so_far - told_lost_;
  told_lost_ = so_far;
  tell(lost);
}

void Engine::report_cancel(Index edge) const {
  Event cancel = event(Event::Kind::input, edge == nil ? nil : x_.t.edges[edge].target);
  cancel.input = Event::Input::cancel;
  cancel.edge = edge;
  tell(cancel);
}

void Engine::report_input(const Input& record) const {
  if (record.kind == Input::Kind::cancel && record.thing == nil) { // first of all, and then of each
    report_cancel(nil);
    for (Index edge = 0; edge < x_.t.root_edges; ++edge) {
      if (x_.s.request[edge].level != nil) report_cancel(edge);
    }
    return;
  }
  Event input = event(Event::Kind::input);
  constexpr Event::Input kinds[] = {Event::Input::request, Event::Input::cancel, Event::Input::set,
                                    Event::Input::fire,    Event::Input::enable, Event::Input::disable};
  input.input = kinds[static_cast<std::size_t>(record.kind)];
  switch (record.kind) {
  case Input::Kind::cancel: return report_cancel(record.thing);
  case Input::Kind::request:
    input.edge = record.thing;
    input.group = x_.t.edges[record.thing].target;
    input.level = record.level();
    break;
  case Input::Kind::set:
    input.state = record.thing;
    input.value = record.value;
    break;
  case Input::Kind::fire: input.trigger = record.thing; break;
  case Input::Kind::enable:
  case Input::Kind::disable:
    input.provider = record.thing;
    input.group = x_.t.providers[record.thing].group;
    break;
  }
  tell(input);
}

void Engine::report_decisions(Index component) const {
  const Component& row = x_.t.components[component];
  for (const Index g : x_.t.list(row.groups)) {
    if (x_.s.last[g].push.edge != nil && x_.s.now[g].push.edge == nil) tell(event(Event::Kind::release, g));
  }
  for (const Index g : x_.t.list(row.groups)) {
    const Push &now = x_.s.now[g].push, &last = x_.s.last[g].push;
    if (now.edge == nil || (now.edge == last.edge && now.provider == last.provider)) continue;
    Event push = event(Event::Kind::push, g);
    push.provider = now.provider;
    push.edge = now.edge;
    push.condition = now.condition;
    tell(push);
  }
  report_queued(component);
  for (const Index g : x_.t.list(row.groups)) {
    const Index now = x_.s.now[g].holder, last = x_.s.last[g].holder;
    if (now == last) continue;
    Event control = event(now == nil ? Event::Kind::lose : Event::Kind::grant, g);
    control.edge = now;
    control.other = last;
    control.provider = x_.s.now[g].active;
    tell(control);
  }
}

void Engine::report_queued(Index component) const {
  for (const Index e : x_.t.list(x_.t.components[component].edges)) {
    const Queued &now = x_.s.queued[e], &last = x_.s.last_queued[e];
    if (now.why == Why::none || now == last) continue;
    Event queue = event(Event::Kind::queue, x_.t.edges[e].target);
    queue.edge = e;
    queue.why = now.why;
    queue.condition = now.condition;
    tell(queue);
  }
}

/// What only an observer wants to know: why everything was queued before.
void Engine::remember_queued(Index component) {
  for (const Index e : x_.t.list(x_.t.components[component].edges)) x_.s.last_queued[e] = x_.s.queued[e];
}

} // namespace director
