// docs/semantics.md, section 2: the state as it can be read from outside.
// SPDX-License-Identifier: MIT

#include "runtime/core/inspect/view.hpp"

#include "runtime/core/engine/engine.hpp"

namespace director {

View view_of(const Engine& engine) {
  const State& memory = engine.memory();
  return {.tables = &engine.tables(),
          .now = engine.now(),
          .micro_step = engine.micro_steps(),
          .passes = engine.passes(),
          .lost = engine.lost(),
          .request = memory.request,
          .values = memory.values,
          .assignment = memory.last.group,
          .queued_edge = memory.queued,
          .run_queue = memory.run_queue,
          .enabled = memory.enabled};
}

std::int32_t View::priority(Index edge) const {
  if (requested(edge)) return tables->levels[request[edge].level].priority;
  const Range levels = tables->edges[edge].levels;
  return levels.empty() ? 0 : tables->levels[levels.begin].priority;
}

RunState View::state(Index edge) const {
  const Index group = tables->edges[edge].target;
  if (granted(group) && holder(group) == edge) return RunState::running;
  return requested(edge) ? RunState::queued : RunState::none;
}

Holding View::holding(Index group) const {
  const Index edge = holder(group);
  if (edge == nil) return {};
  if (is_limbo(edge)) return {.by = Holding::By::limbo, .edge = edge};
  const Index requester = tables->edges[edge].requester;
  return {.by = requester == nil ? Holding::By::program : Holding::By::group,
          .group = requester,
          .edge = edge,
          .granted = granted(group)};
}

View View::copy(std::byte* buffer) const {
  View out = *this;
  out.each(Shape::of(*tables), [&]<class T>(const T*& array, std::size_t count) {
    T* const to = reinterpret_cast<T*>(buffer); // the arrays are created in the bytes of the buffer
    for (std::size_t i = 0; i < count; ++i) to[i] = array[i];
    array = to;
    buffer += count * sizeof(T);
  });
  return out;
}

} // namespace director
