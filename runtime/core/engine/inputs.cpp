// docs/semantics.md, section 3, Inputs: what the outside asks for, sets and fires.
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

Engine::Taken Engine::take_request(Input& record) {
  if (bodies_.data != nullptr) return take_request_with_data(record);
  if (record.more || !asks_again(record.thing, record.level())) return take_requests(record);
  give_what_is_asked_again(record.thing);
  return Taken::no_change;
}

[[gnu::noinline]] Engine::Taken Engine::take_requests(Input& record) {
  do {
    if (bodies_.data != nullptr) bodies_.data(bodies_.self, Bodies::Data::accept, record.thing, record.handle);
    request(record.thing, record.level());
  } while (take_more(record));
  return Taken::change;
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

} // namespace director
