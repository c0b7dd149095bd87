#pragma once
// SPDX-License-Identifier: MIT
// The state between two micro-steps, as it can be read from outside: holders, requests, values. A view reads the memory
// of an engine, or a copy of it (View::copy).

#include "runtime/core/base/state.hpp"

namespace director {

class Engine;

/// The holder of a group.
struct Holding {
  /// What holds it.
  enum class By : std::uint8_t {
    nobody,  ///< it is free
    program, ///< requested as a root task
    group,   ///< requested or needed by `group`
    limbo,   ///< in limbo: kept for a stale group that may still request it
  };
  By by = By::nobody;   ///< what holds it
  Index group = nil;    ///< of By::group
  Index edge = nil;     ///< by which it is requested or needed; nil: nobody
  bool granted = false; ///< false: it is held only as a need, and was not requested yet
  constexpr bool operator==(const Holding&) const = default; ///< all members are equal
};

struct View {
  const Tables* tables = nullptr;
  Time now = 0;                 ///< the engine's time
  std::uint64_t micro_step = 0; ///< micro-steps taken
  std::uint64_t passes = 0;     ///< passes so far, and loads: these may restore the number of an earlier micro-step
  std::uint32_t lost = 0; ///< inputs that were refused so far, because the inbox was full, or replaced by a later one

  // One row for each group, edge, provider or state; see State.
  const Requested* request = nullptr;
  const StateValue* values = nullptr;
  const GroupAssignment* assignment = nullptr;
  const Queued* queued_edge = nullptr; ///< why it is queued, by the last pass
  const RunQueueEntry* run_queue = nullptr;
  const Bits* enabled = nullptr;

  bool is_limbo(Index edge) const { return edge != nil && edge >= tables->edges.size(); }
  Index holder(Index group) const { return assignment[group].holder; }
  bool granted(Index group) const { return assignment[group].granted(); }
  bool requested(Index edge) const { return request[edge].level != nil; }
  std::int32_t priority(Index edge) const;                      ///< of the request; of a need: of the first level, or 0
  RunState state(Index edge) const;                             ///< of a request: running, queued or none
  Queued queued(Index edge) const { return queued_edge[edge]; } ///< why it is queued
  Holding holding(Index group) const;

private:
  /// Calls visit(array, count) for every array, in decreasing alignment. clang++ needs it before its uses.
  template <class Visit>
  constexpr void each(const Shape& n, Visit&& visit) {
    visit(request, n.edges), visit(values, n.states), visit(assignment, n.groups);
    visit(queued_edge, n.edges), visit(run_queue, n.groups), visit(enabled, n.providers);
  }

public:
  /// The size of a copy, in bytes; it is aligned to 8.
  static constexpr std::size_t bytes(const Shape& shape) {
    View view;
    std::size_t size = 0;
    view.each(shape, [&]<class T>(const T*, std::size_t count) { size += count * sizeof(T); });
    return (size + 7) / 8 * 8;
  }
  /// Copies the arrays to a buffer of that size; returns a view of the copy.
  View copy(std::byte* buffer) const;
};

/// A view of the memory of the engine.
View view_of(const Engine& engine);

} // namespace director
