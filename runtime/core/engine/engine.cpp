// docs/semantics.md, sections 2 and 6: the state between micro-steps, and the contexts of bodies and handlers.
// SPDX-License-Identifier: MIT

#include "runtime/core/engine/notes.hpp"

namespace director {

Engine::Engine(const Tables& tables, const State& memory, const Bodies& bodies, Inbox& inbox)
    : x_{tables, memory},
      timers_(x_.t, x_.s),
      bodies_(bodies),
      inbox_(inbox) {
  reset();
}

void Engine::reset() {
  passes_ = 0;
  const State& s = x_.s;
  for (auto* at = reinterpret_cast<std::byte*>(s.counters); at != s.end; ++at)
    *at = {}; // members that are not 0 follow
  *s.counters = {};
  timers_.clear();
  for (Index i = 0; i < x_.t.states.size(); ++i) {
    s.values[i].value = x_.t.states[i].initial;
    s.values[i].staged = unset;
    update_conditions(i);
  }
  for (Index p = 0; p < x_.t.providers.size(); ++p) s.enabled[p] = 1;
  for (Index e = 0; e < x_.t.edges.size(); ++e) {
    s.request[e].target = x_.t.edges[e].target;
    s.request[e].level = s.queued[e].condition = nil;
  }
  for (Index i = 0; i <= x_.t.most_edges; ++i) s.staged_request[i].level = nil;
  for (Index slot = 0; slot < x_.t.plan_groups.size(); ++slot) s.last.plan[slot] = nil;
  for (Index g = 0; g < x_.t.groups.size(); ++g) {
    const Group& row = x_.t.groups[g];
    s.last[g] = {};
    s.trial[g] = s.data_from[g] = nil;
    if (!x_.t.promises.empty()) s.promised[g] = {};
    RunQueueEntry& entry = s.run_queue[g];
    entry.runs_after = entry.runs_before = nil;
    entry.component = row.component;
    if (row.start || row.stop || !row.owned.empty() ||
        any(row.providers.rows(), [&](Index p) { return x_.t.providers[p].every != 0; }))
      entry.flags |= group_flag::lifecycle;
  }
  for (Index c = 0; c < x_.t.components.size(); ++c) {
    Index* link = &s.first_root[c];
    for (const Index e : x_.t.list(x_.t.components[c].edges)) {
      if (x_.t.edges[e].requester != nil) break; // edges of root come first
      *link = e;
      link = &s.next_root[e];
    }
    *link = nil;
    s.component[c] = work::reordered;
  }
  arbitration::forget_trail(x_);
  starting_ = nil;
  inside_ = faulted_ = false;
}

RunState Engine::state(Index edge) const {
  if (arbitration::was_granted(x_, edge)) return RunState::running;
  return x_.s.request[edge].level != nil ? RunState::queued : RunState::none;
}

bool Engine::answered(Index edge, std::uint8_t answer) const {
  return x_.s.run_queue[x_.t.edges[edge].target].done.has(answer) && arbitration::was_granted(x_, edge);
}

Time Run::now() const { return engine_.now(); }
RunState Run::state(Index edge) const { return engine_.state(edge); }
bool Run::done(Index edge) const { return engine_.answered(edge, result::done); }
bool Run::failed(Index edge) const { return engine_.answered(edge, result::failed); }

/// A start handler may run for a request of this micro-step, whose data are still staged.
DataPlace Call::data() const {
  const Index edge = engine_.x_.s.data_from[group_];
  if (edge == nil) return {DataPlace::Slot::group, group_};
  if (engine_.starting_ == group_ && engine_.x_.s.anew[edge] != 0) return {DataPlace::Slot::staging, edge};
  return {DataPlace::Slot::edge, edge};
}

/// Only the last answer of a run counts.
void Run::forget_pack() {
  for (Index i = 0; i < engine_.x_.t.groups[group_].edges.size(); ++i) staged_[i].level = nil;
}

void Run::set(Index state, std::int32_t value) { engine_.stage(state, value); }

bool Run::triggered(Index trigger) const {
  const arbitration::Context& x = engine_.x_;
  return any(x.t.groups[group_].listens.rows(),
             [&](Index slot) { return x.t.listened[slot] == trigger && x.s.fired[slot] != 0; });
}

void Call::refuse(Index state, std::int32_t value) {
  if (engine_.observed()) engine_.report_value(Event::Kind::refused, group_, provider_, state, value);
}

} // namespace director
