// docs/semantics.md, section 3: values of states, and the conditions that flip with them.
// SPDX-License-Identifier: MIT

#include "runtime/core/engine/notes.hpp"

namespace director {

const char part::states = 0;

void Engine::preset(Index state, std::int32_t value) {
  x_.s.values[state].value = value;
  update_conditions(state);
}

/// Starts the expiry of values with the first step.
void Engine::begin_to_expire() {
  for (Index i = 0; i < x_.t.states.size(); ++i) {
    if (x_.t.states[i].expires != 0 && x_.s.values[i].value != unset)
      timers_.arm({Timers::Kind::expiry, i}, later(x_.s.counters->now, x_.t.states[i].expires));
  }
}

bool Engine::take_states(const Input& first) {
  bool changes = false;
  for (const Input* record = &first; record != nullptr; record = take_more(*record))
    changes = set_value(record->thing, record->value) || changes;
  return changes;
}

bool Engine::expire(Index state) {
  if (!assign(state, x_.t.states[state].expires_to)) return false;
  if (observed()) report_set(state);
  return true;
}

/// Evaluates the conditions on a state with a new value. Components in which a condition flips are decided again,
/// except before the first step. While a state is unset, none of its conditions holds, and any value may change that.
void Engine::update_conditions(Index state) {
  const std::int32_t value = x_.s.values[state].value;
  Interval unchanged{unset + 1, 2147483647};
  if (value == unset) unchanged = {unset, unset};
  for (const Index condition : x_.t.list(x_.t.states[state].conditions)) {
    const Condition& row = x_.t.conditions[condition];
    bool now = false;
    for (Index i = row.accepts.begin; i != row.accepts.end && value != unset; ++i) {
      const Interval& accepted = x_.t.intervals[i];
      now = now || accepted.has(value); // and no bound of the condition is inside of `unchanged`
      const std::int32_t low = accepted.high < value ? accepted.high + 1 : accepted.low;
      const std::int32_t high = accepted.low > value ? accepted.low - 1 : accepted.high;
      if (low <= value && low > unchanged.low) unchanged.low = low;
      if (high >= value && high < unchanged.high) unchanged.high = high;
    }
    if (now == arbitration::holds(x_, condition)) continue;
    x_.s.truth[condition] = now ? 1 : 0;
    if (!x_.s.counters->begun) continue;
    for (const Index component : x_.t.list(row.components)) mark(component, work::changed);
    for (const Index group : x_.t.list(row.groups)) arbitration::note_flipped(x_, group);
  }
  x_.s.values[state].unchanged = unchanged;
}

/// Takes the staged values, or drops them after a fault. True if a value changes.
bool Engine::commit_states(bool fault) {
  Counters& c = *x_.s.counters;
  bool changes = false;
  for (Index i = 0; i < c.staged_count; ++i) {
    const Index state = x_.s.staged[i];
    const std::int32_t value = std::exchange(x_.s.values[state].staged, unset);
    if (fault || value == unset || !set_value(state, value)) continue;
    changes = true;
    if (observed()) report_set(state);
  }
  c.staged_count = 0;
  return changes;
}

} // namespace director
