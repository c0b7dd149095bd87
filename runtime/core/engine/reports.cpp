// docs/programs.md, Observers: events for an observer. Without one, no code here is linked.
// SPDX-License-Identifier: MIT

#include "runtime/core/engine/engine.hpp"

namespace director {

using Kind = Event::Kind;

void Engine::observe(Observer observer) { observer_ = observer; }

void Engine::notify(Event&& event) const {
  event.time = x_.s.counters->now;
  event.until = x_.s.counters->until;
  event.micro_step = x_.s.counters->micro_step;
  observer_.tell(observer_.self, event);
}

void Engine::report_run(Kind kind, Index group, Index provider, Reasons reasons) const {
  notify({.kind = kind, .reasons = reasons, .group = group, .provider = provider});
}

void Engine::report_request(Kind kind, Index edge, Index level) const {
  notify({.kind = kind, .group = x_.t.edges[edge].target, .edge = edge, .level = level});
}

void Engine::report_begin() const {
  report(Kind::begin);
  for (Index i = 0; i < x_.t.states.size(); ++i) {
    const std::int32_t value = x_.s.values[i].value;
    if (value != x_.t.states[i].initial) report_value(Kind::given, nil, nil, i, value);
  }
}

/// Reports the answer, and the states that the run sets, including those that have the value already.
void Engine::report_answer(Index group, Index provider, Outcome::Kind outcome, std::uint16_t pack) const {
  if (outcome != Outcome::Kind::pack) pack = 0;
  notify({.kind = Kind::answer, .group = group, .provider = provider, .outcome = outcome, .pack = pack});
  for (Index i = 0; i < x_.s.counters->staged_count && outcome != Outcome::Kind::fault; ++i)
    report_value(Kind::assign, group, provider, x_.s.staged[i], x_.s.values[x_.s.staged[i]].staged);
}

void Engine::report_value(Kind kind, Index group, Index provider, Index state, std::int32_t value) const {
  notify({.kind = kind, .group = group, .provider = provider, .state = state, .value = value});
}

void Engine::report_set(Index state) const { report_value(Kind::set, nil, nil, state, x_.s.values[state].value); }

void Engine::report_wait(Index group, Time due) const { notify({.kind = Kind::wait, .group = group, .due = due}); }

void Engine::report_timer(Timers::Timer timer) const {
  switch (timer.kind) {
  case Timers::Kind::expiry: return notify({.input = Event::Input::expire, .state = timer.row});
  case Timers::Kind::wait: return notify({.input = Event::Input::wait, .group = timer.row});
  case Timers::Kind::every: return notify({.input = Event::Input::every, .group = timer.row});
  case Timers::Kind::promise: break;
  }
  const Index provider = x_.t.promises[timer.row].provider;
  notify({.input = Event::Input::within, .group = x_.t.providers[provider].group, .provider = provider});
}

void Engine::report_lost() {
  const std::uint32_t so_far = inbox_.lost();
  notify({.kind = Kind::lost, .count = so_far - std::exchange(reported_lost_, so_far)});
}

void Engine::report_input(const Input& record) const {
  const Index row = record.thing;
  switch (record.kind) {
  case Input::Kind::request:
    return notify(
        {.input = Event::Input::request, .group = x_.t.edges[row].target, .edge = row, .level = record.level()});
  case Input::Kind::set: return notify({.input = Event::Input::set, .state = row, .value = record.value});
  case Input::Kind::fire: return notify({.input = Event::Input::fire, .trigger = row});
  case Input::Kind::enable:
    return notify({.input = Event::Input::enable, .group = x_.t.providers[row].group, .provider = row});
  case Input::Kind::disable:
    return notify({.input = Event::Input::disable, .group = x_.t.providers[row].group, .provider = row});
  case Input::Kind::cancel: break;
  }
  if (row != nil) return notify({.input = Event::Input::cancel, .group = x_.t.edges[row].target, .edge = row});
  notify({.input = Event::Input::cancel});
  for (Index edge = 0; edge < x_.t.root_edges; ++edge) {
    if (x_.s.request[edge].level != nil) report_input({.kind = Input::Kind::cancel, .thing = edge});
  }
}

void Engine::report_decisions(Index component) const {
  const auto groups = x_.t.list(x_.t.components[component].groups);
  for (const Index g : groups) {
    if (x_.s.last[g].push.edge != nil && x_.s.now[g].push.edge == nil) report(Kind::release, g);
  }
  for (const Index g : groups) {
    const auto [edge, provider, condition] = x_.s.now[g].push;
    const Push& last = x_.s.last[g].push;
    if (edge == nil || (edge == last.edge && provider == last.provider)) continue;
    notify({.kind = Kind::push, .group = g, .provider = provider, .edge = edge, .condition = condition});
  }
  for (const Index e : x_.t.list(x_.t.components[component].edges)) {
    const auto [why, condition] = x_.s.queued[e];
    if (why == Why::none || x_.s.queued[e] == x_.s.last_queued[e]) continue;
    notify({.kind = Kind::queue, .why = why, .group = x_.t.edges[e].target, .edge = e, .condition = condition});
  }
  for (const Index g : groups) {
    const Index now = x_.s.now[g].holder, last = x_.s.last[g].holder;
    const Kind kind = now == nil ? Kind::lose : Kind::grant;
    if (now != last) notify({.kind = kind, .group = g, .provider = x_.s.now[g].active, .edge = now, .other = last});
  }
}

/// Remembers, for an observer, why each request was queued before.
void Engine::remember_queued(Index component) {
  for (const Index e : x_.t.list(x_.t.components[component].edges)) x_.s.last_queued[e] = x_.s.queued[e];
}

} // namespace director
