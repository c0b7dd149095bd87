#pragma once
// SPDX-License-Identifier: MIT
// A known move (recalled.cpp) is made in the loop of micro-steps, without a call: what is written down of it
// (foresee.cpp) is written where the groups stand. Only the engine's own files include it.

#include "runtime/core/decision.hpp"
#include "runtime/core/notes.hpp"

#include <cstddef>

namespace director {

/// Visits so many rows. The one behind them.
template <class Visit>
DIRECTOR_INLINE const Recall::Effect* each_row(const Recall::Effect* row, std::uint8_t count, Visit&& visit) {
  for (const Recall::Effect* const end = row + count; row != end; ++row) visit(*row);
  return row;
}

DIRECTOR_INLINE void Engine::note_recalled(const Recall::Part& known, const Recall::Move& move) {
  ++recalled_;
  Recall::Head& head = known.head();
  if (head.used != 0xff) ++head.used;
  known.take(move);
}

/// The situation's bytes tell all of it.
DIRECTOR_INLINE bool Engine::told(Index component, const Recall::Part& known) const {
  Recall::Ties& ties = known.head().ties;
  if (ties <= Recall::Ties::in_order) return true;
  if (ties == Recall::Ties::unknown) ties = find_order(component);
  return ties == Recall::Ties::in_order;
}

/// A reason to run for a group that is granted. Which are news.
DIRECTOR_INLINE std::uint8_t Engine::note_effect(const Recall::Effect& row) {
  const auto group = static_cast<Index>(row.where);
  untouch(group);
  live_on(group, s_.last[group].holder);
  return note_news(group, static_cast<std::uint8_t>(row.value));
}

/// What follows from the news, but for the run.
DIRECTOR_INLINE void Engine::note_outdated(const Recall::Effect& row, std::uint8_t news) {
  if ((news & reason::outdating) == 0) return;
  if ((row.value & Recall::Effect::again) == 0) mark_stale(static_cast<Index>(row.where));
  note_pending(static_cast<Index>(row.where));
}

/// As arbitrate(), where only one component is to be decided, it was in this situation before, and what followed is
/// written down: it is written where it belongs, and nobody looks for what differs. False: nothing was done.
DIRECTOR_INLINE bool Engine::retrace() {
  const Index component = s_.work[0];
  const Recall::Part known = recall_.part(component);
  if (!known || !told(component, known)) return false;
  Recall::Move* const found = known.find();
  if (found == nullptr) return false;
  if ((found->bits & moved::foreseen) == 0 && !foresee(component, known, *found)) return false;
  const Recall::Move& move = *found;
  note_recalled(known, move);
  Counters& c = *s_.counters;
  const std::uint8_t left = s_.component[component] = settled_bits(component, move.component);
  c.work_count = (left & work::listed) != 0 ? 1 : 0;
  if ((move.bits & moved::other_decision) != 0) c.unsettled = true;
  if (observed()) foretell(component, known.row(move.to));

  const Recall::Effect* row = known.effects(move);
  const bool rare = (move.bits & moved::rare) != 0;
  if (rare) {
    row = each_row(row, move.stops, [&](const Recall::Effect& it) { stop_group(static_cast<Index>(it.where)); });
    if ((move.bits & moved::begins) != 0) begin_groups(component, known, move);
  }
  auto* const memory = reinterpret_cast<std::byte*>(s_.counters);
  row = each_row(row, move.words,
                 [&](const Recall::Effect& it) { *reinterpret_cast<AnyWord*>(memory + it.where) = it.value; });
  if (rare)
    row = each_row(row, move.leaves, [&](const Recall::Effect& it) { leave_queue(static_cast<Index>(it.where)); });
  if (c.touched_count != move.asked && !planted(Fault::others_are_overlooked)) {
    give_and_join(component, row, move);
  } else {
    row = each_row(row, move.gives, [&](const Recall::Effect& it) {
      const std::uint8_t news = note_effect(it);
      enqueue(static_cast<Index>(it.where));
      note_outdated(it, news);
    });
    if (rare) each_row(row, move.passed, [&](const Recall::Effect& it) { untouch(static_cast<Index>(it.where)); });
    c.touched_count = 0;
  }
  keep_promises_in(component);
  return true;
}

} // namespace director
