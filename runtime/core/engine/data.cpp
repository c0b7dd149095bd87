// runtime/core/README.md, The memory: moves the data of tasks when they are requested.
// SPDX-License-Identifier: MIT

#include "runtime/core/engine/notes.hpp"

namespace director {

const char part::data = 0;

bool Engine::take_request_with_data(const Input& record) {
  if (record.more || !repeats_request(record.thing, record.level())) return take_requests(record);
  bodies_.data(bodies_.self, Bodies::Data::accept, record.thing, record.handle);
  run_for_repeated_request(record.thing);
  return false;
}

/// Moves the data of a new request to the slot of its edge. Data there that a group still uses are retained.
void Engine::settle_data(Index edge) {
  const Index group = x_.t.edges[edge].target;
  if (!arbitration::was_granted(x_, edge) && x_.s.last[group].active != nil && x_.s.data_from[group] == edge) {
    bodies_.data(bodies_.self, Bodies::Data::retain, edge, nil);
    use_data_of(group, nil);
  }
  bodies_.data(bodies_.self, Bodies::Data::settle, edge, nil);
}

} // namespace director
