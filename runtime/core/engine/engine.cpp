// docs/semantics.md, section 6: what is asked from outside a micro-step, and what bodies and handlers see and ask for.
// SPDX-License-Identifier: MIT

#include "runtime/core/engine/engine.hpp"

#include "runtime/core/arbitration/pass.hpp"
#include "runtime/core/base/marks.hpp"

#include <type_traits>

namespace director {

namespace {

template <class T>
[[gnu::noinline]] void fill(T* array, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) array[i] = T{};
}

} // namespace

Engine::Engine(const Tables& tables, const State& memory, const Bodies& bodies, Inbox& inbox)
    : x_{tables, memory},
      timers_(x_.t, x_.s),
      bodies_(bodies),
      inbox_(inbox) {
  reset();
}

void Engine::reset() {
  passes_ = 0;
  for (auto* at = reinterpret_cast<std::byte*>(x_.s.counters); at != x_.s.end; ++at) *at = {};
  State::each(
      x_.s, Shape::of(x_.t),
      []<class T>(T*& array, std::size_t count) {
        if constexpr (!std::is_trivially_default_constructible_v<T>)
          fill(array, count); // what else there is begins with 0
      },
      [] {});
  timers_.clear();
  for (Index i = 0; i < x_.t.states.size(); ++i) {
    x_.s.values[i].value = x_.t.states[i].initial;
    x_.s.handler_values[i] = unset;
    look_at_conditions(i);
  }
  for (Index p = 0; p < x_.t.providers.size(); ++p) x_.s.enabled[p] = 1;
  for (Index e = 0; e < x_.t.edges.size(); ++e) x_.s.request[e].target = x_.t.edges[e].target;
  for (Index slot = 0; slot < x_.t.plan_groups.size(); ++slot) x_.s.last.plan[slot] = nil;
  for (Index g = 0; g < x_.t.groups.size(); ++g) x_.s.trial[g] = x_.s.data_from[g] = nil;
  for (Index c = 0; c < x_.t.components.size(); ++c) {
    Index* link = &x_.s.first_root[c];
    for (const Index e : x_.t.list(x_.t.components[c].edges)) {
      if (x_.t.edges[e].requester != nil) break; // edges of root come first
      *link = e;
      link = &x_.s.next_root[e];
    }
    *link = nil;
    x_.s.component[c] = work::reordered;
    for (const Index g : x_.t.list(x_.t.components[c].groups)) {
      RunQueueEntry& entry = x_.s.run_queue[g];
      entry.component = c;
      entry.flags = flags_of(g);
    }
  }
  arbitration::forget_trail(x_);
  starting_ = nil;
  inside_ = faulted_ = false;
}

/// The bits that follow from the tables.
std::uint8_t Engine::flags_of(Index group) const {
  const Group& row = x_.t.groups[group];
  bool ends = row.start || row.stop || !row.owned.empty();
  for (Index p = row.providers.begin; p != row.providers.end; ++p) ends = ends || x_.t.providers[p].every != 0;
  return static_cast<std::uint8_t>((row.listens.empty() ? 0 : group_flag::listens) | (ends ? group_flag::ends : 0));
}

RunState Engine::state(Index edge) const {
  const Index group = x_.t.edges[edge].target;
  if (granted(group) && x_.s.last[group].holder == edge) return RunState::running;
  return x_.s.request[edge].level != nil ? RunState::queued : RunState::none;
}

bool Engine::done(Index edge) const {
  return x_.s.run_queue[x_.t.edges[edge].target].done != 0 && state(edge) == RunState::running;
}

bool Engine::failed(Index edge) const {
  return (x_.s.run_queue[x_.t.edges[edge].target].done & result::failed) != 0 && state(edge) == RunState::running;
}

/// Where the data of the task are that the group was given last. A start handler may be called for a request of this
/// very micro-step, whose data are settled after the act.
DataPlace Engine::data_of(Index group) const {
  const Index edge = x_.s.data_from[group];
  if (edge == nil) return {DataPlace::Slot::group, group};
  if (starting_ == group && x_.s.anew[edge] != 0) return {DataPlace::Slot::staging, edge};
  return {DataPlace::Slot::edge, edge};
}

// What a body sees and asks for.

Time Run::now() const { return engine_.now(); }
RunState Run::state(Index edge) const { return engine_.state(edge); }
bool Run::done(Index edge) const { return engine_.done(edge); }
bool Run::failed(Index edge) const { return engine_.failed(edge); }
DataPlace Run::data() const { return engine_.data_of(group_); }
void Run::wait(Time duration) { wait_ = duration; }

void Run::set(Index state, std::int32_t value) {
  const State& s = engine_.x_.s;
  if (s.values[state].staged == unset) s.staged[s.counters->staged_count++] = state;
  s.values[state].staged = value;
}

bool Run::triggered(Index trigger) const {
  const Range listens = engine_.x_.t.groups[group_].listens;
  for (Index slot = listens.begin; slot != listens.end; ++slot) {
    if (engine_.x_.t.listened[slot] == trigger) return engine_.x_.s.fired[slot] != 0;
  }
  return false;
}

void Run::refuse(Index state, std::int32_t value) {
  if (engine_.observed()) engine_.report_value(Event::Kind::refused, group_, provider_, state, value);
}

} // namespace director
