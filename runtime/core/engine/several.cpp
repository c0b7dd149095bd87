// docs/semantics.md, sections 3 and 5: code that only behaviours of several groups need.
// SPDX-License-Identifier: MIT

#include "runtime/core/base/heap_sort.hpp"
#include "runtime/core/engine/notes.hpp"

namespace director {

const char part::several = 0;

/// Carries out the requests and withdrawals of a run.
void Engine::commit_pack(Range edges) {
  Staged* staged = x_.s.staged_request;
  for (Index e = edges.begin; e != edges.end; ++e, ++staged) {
    const Index level = std::exchange(staged->level, nil);
    if (level == nil) {
      if (observed() && x_.s.request[e].level != nil) report_request(Event::Kind::withdraw, e);
      withdraw(e);
      continue;
    }
    if (observed()) report_request(staged->keep ? Event::Kind::keep : Event::Kind::ask, e, level);
    if (staged->keep) continue;
    if (edges.size() == 1 && repeats_request(e, level)) {
      run_for_repeated_request(e);
    } else {
      request(e, level);
    }
  }
}

bool Engine::other_plan(Index group) const {
  return any(x_.t.groups[group].slots.rows(), [&](Index slot) { return x_.s.now.plan[slot] != x_.s.last.plan[slot]; });
}

void Engine::act_on_all_touched() {
  Counters& c = *x_.s.counters;
  const Index touched = c.touched_count;
  c.touched_count = 0;
  Index count = 0, last = nil; // component
  bool sorted = true;          // the requests of one pack mostly are
  for (Index i = 0; i < touched; ++i) {
    const Index group = x_.s.touched[i];
    untouch(group);
    if (!granted(group)) continue;
    const Index component = x_.s.run_queue[group].component;
    if (count != 0) sorted = sorted && component == last && x_.s.place[x_.s.touched[count - 1]] < x_.s.place[group];
    last = component;
    x_.s.touched[count++] = group;
  }
  if (!sorted) arbitration::sort_by_place(x_, {x_.s.touched, count}, arbitration::Chains::previous);
  for (Index i = 0; i < count; ++i) queue_run(x_.s.touched[i], x_.s.anew[x_.s.last[x_.s.touched[i]].holder] != 0);
}

/// Remembers a request before its first change in this micro-step.
void Engine::remember_request(Index edge) {
  Bits& bits = x_.s.edge_trail[edge];
  if (bits.has(trail::altered)) return;
  bits |= trail::altered;
  Requested& row = x_.s.before[x_.before_count++];
  row = x_.s.request[edge];
  row.target = edge;
}

/// Swaps requests with those before this micro-step; the second call swaps them back.
void Engine::swap_altered() {
  for (Requested& row : std::span(x_.s.before, x_.before_count)) {
    Requested& request = x_.s.request[row.target];
    std::swap(request.level, row.level);
    std::swap(request.stamp, row.stamp);
  }
}

void Engine::forget_altered() {
  for (const Requested& row : std::span(x_.s.before, x_.before_count))
    x_.s.edge_trail[row.target].remove(trail::altered);
  x_.before_count = 0;
}

/// Sorts the components, so that the order of events does not depend on how much was decided again.
void Engine::sort_work() {
  heap_sort({x_.s.work, x_.s.counters->work_count}, [](Index a, Index b) { return a < b; });
}

/// The held groups of these components in the old order, that of the requests before this micro-step.
std::span<const Index> Engine::held_in_all(Index passes) {
  swap_altered();
  Index count = 0;
  for (Index i = 0; i < passes; ++i) {
    for (const Index group : held_in(x_.s.work[i])) x_.s.reach[count++] = group;
  }
  arbitration::sort_by_holders(x_, {x_.s.reach, count}, arbitration::Chains::previous);
  swap_altered();
  return {x_.s.reach, count};
}

} // namespace director
