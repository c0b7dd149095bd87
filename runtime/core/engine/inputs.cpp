// docs/semantics.md, section 3, Inputs.
// SPDX-License-Identifier: MIT

#include "runtime/core/engine/notes.hpp"

namespace director {

/// Long cases are functions of their own, called last, so that the short cases stay short.
bool Engine::take_input(const Input& record) {
  ++x_.s.counters->micro_step;
  if (observed()) report_input(record);
  switch (record.kind) {
  case Input::Kind::request:
    if (bodies_.data != nullptr) return take_request_with_data(record);
    if (record.more || !repeats_request(record.thing, record.level())) return take_requests(record);
    run_for_repeated_request(record.thing);
    return false;
  case Input::Kind::set: return take_states(record);
  case Input::Kind::cancel: return take_cancel(record.thing);
  case Input::Kind::fire: return fire(record.thing);
  case Input::Kind::enable: return take_enabled(record.thing, 1);
  case Input::Kind::disable: return take_enabled(record.thing, 0);
  }
  return false;
}

[[gnu::noinline]] bool Engine::take_requests(const Input& first) {
  for (const Input* record = &first; record != nullptr; record = take_more(*record)) {
    if (bodies_.data != nullptr) bodies_.data(bodies_.self, Bodies::Data::accept, record->thing, record->handle);
    request(record->thing, record->level());
  }
  return true;
}

/// Withdraws the request on an edge of root; nil: all requests of root.
[[gnu::noinline]] bool Engine::take_cancel(Index edge) {
  const Index end = edge == nil ? x_.t.root_edges : static_cast<Index>(edge + 1);
  bool changes = false;
  for (Index e = edge == nil ? 0 : edge; e != end; ++e) changes = withdraw(e) || changes;
  return changes;
}

[[gnu::noinline]] bool Engine::take_enabled(Index provider, std::uint8_t wanted) {
  if (x_.s.enabled[provider] == wanted) return false;
  x_.s.enabled[provider] = wanted;
  const Index component = x_.t.groups[x_.t.providers[provider].group].component;
  mark(component, work::changed);
  x_.s.news_count[component] = nil; // which units may push it is not noted, and this is rare
  return true;
}

} // namespace director
