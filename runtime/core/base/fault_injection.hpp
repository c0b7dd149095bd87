#pragma once
// SPDX-License-Identifier: MIT
// Faults that can be planted in the engine, to test that the random tests of tests/property find each of them. In a
// product injected() is false at compile time, and no code of a fault is left. tests/planted builds the engine with
// DIRECTOR_FAULT_INJECTION and chooses one at a time.

namespace director {

enum class Fault : unsigned char {
  none,
  // semantics.md 4.1
  ancestors_are_equals,
  optional_goes_first,
  priorities_are_reversed,
  younger_goes_first,
  // 4.2
  equals_take,
  denials_are_final,
  denials_of_unchanged_units_are_overlooked,
  // 4.3
  only_the_first_plan,
  disabled_providers_run,
  stay_is_ignored,
  pushes_move_nothing,
  nothing_is_waived,
  // 4.4
  members_are_granted_alone,
  stale_groups_acquire,
  nothing_is_deferred,
  served_pushes_end,
  blocked_units_push_on,
  pushes_without_a_causer,
  the_later_provider_is_pushed,
  limbo_keeps_nothing,
  pushes_outlive_requests,
  // 5
  stopped_requests_stay,
  owned_states_stay,
  a_new_holder_gives_no_reason,
  unwanted_needs_live_on,
  a_lost_state_gives_no_reason,
  done_outlives_a_new_task,
  // A change that should cause a new decision is overlooked (act.cpp).
  staleness_is_overlooked,
  conditions_are_overlooked,
  enabling_is_overlooked,
  // A pass overlooks a dependence of units (trail.cpp).
  other_members_are_overlooked,
  units_stay_in_place,
  groups_below_are_overlooked,
  users_are_overlooked,
  waiting_units_are_overlooked,
  waiting_lines_are_overlooked,
  the_rest_is_always_unchanged,
  the_last_result_is_always_settled,
  ended_requests_are_overlooked,
  stale_requesters_are_overlooked,
  the_last_result_is_overlooked,
  lost_needs_are_overlooked,
  permanent_decisions_are_overlooked,
  // A consequence of a decision is overlooked (act.cpp).
  handlers_are_overlooked,
  the_order_stays,
  unchanged_groups_are_overlooked,
  other_components_are_overlooked,
  lost_groups_stay_queued,
  stops_use_the_new_order,
  count
};

#ifdef DIRECTOR_FAULT_INJECTION
extern Fault injected_fault;
inline bool injected(Fault fault) { return fault == injected_fault; }
#else
constexpr bool injected(Fault) { return false; }
#endif

} // namespace director
