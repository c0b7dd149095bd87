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
  denials_of_who_stands_are_overlooked,
  // 4.3
  only_the_first_plan,
  disabled_providers_run,
  stay_is_ignored,
  pushes_move_nothing,
  nothing_is_waived,
  // 4.4
  members_for_themselves,
  outdated_orders_acquire,
  nothing_is_deferred,
  served_pushes_end,
  blocked_units_push_on,
  pushes_though_the_outside_decides,
  the_later_provider_is_pushed,
  nobody_inherits,
  pushes_outlive_requests,
  // 5
  stopped_requests_stand,
  owned_states_stay,
  a_new_holder_is_no_news,
  unwanted_needs_live_on,
  a_lost_state_is_nobodys_concern,
  done_outlives_a_new_task,
  // A change that should cause a new decision is overlooked (act.cpp).
  who_is_stale_is_overlooked,
  conditions_are_overlooked,
  enabling_is_overlooked,
  // A pass overlooks a dependence of units (trail.cpp).
  other_members_are_overlooked,
  units_stay_in_place,
  what_is_below_is_overlooked,
  who_uses_it_is_overlooked,
  who_waits_is_overlooked,
  who_is_behind_is_overlooked,
  the_rest_stands_always,
  the_last_result_is_always_settled,
  ended_requests_are_overlooked,
  outdated_orders_are_overlooked,
  the_last_result_is_overlooked,
  lost_needs_are_overlooked,
  what_is_always_decided_is_overlooked,
  // A consequence of a decision is overlooked (act.cpp).
  handlers_are_overlooked,
  the_order_stays,
  who_stands_as_before_is_overlooked,
  others_are_overlooked,
  who_leaves_stays_queued,
  what_stops_is_ordered_anew,
  count
};

#ifdef DIRECTOR_FAULT_INJECTION
extern Fault injected_fault;
inline bool injected(Fault fault) { return fault == injected_fault; }
#else
constexpr bool injected(Fault) { return false; }
#endif

} // namespace director
