// Header: tests/defects/meaning/expected.hpp. Test: tests/defects/meaning/measure.cpp.
// SPDX-License-Identifier: MIT
#include "tests/defects/meaning/expected.hpp"

#include <map>
#include <stdexcept>

namespace director::defects {

namespace {

using Kinds = std::set<std::string>;

/// A file that is refused is told as that, whatever is wrong with it.
const Kinds refused_checks{"bad_condition",    "bad_header",           "bad_type",         "duplicate_key",
                           "exclusive_keys",   "import_cycle",         "import_not_found", "input_limit",
                           "language_version", "missing_key",          "redefined_name",   "reserved_name",
                           "start_stop_shape", "type_needs_scanner",   "undefined_name",   "unknown_key",
                           "unprovided_task",  "value_outside_domain", "wrong_node_kind",  "yaml_syntax"};

/// What all shapes of a defect change.
const std::map<std::string, Kinds> by_check{
    {"alternating_providers", {"condition_tightened"}},
    {"always_true_when", {"condition_loosened"}},
    {"causer_goes_first", {"priority"}},
    {"causer_not_running", {"finding_new"}},
    {"contradictory_when", {"condition_tightened"}},
    {"foreign_set", {"sets", "handler", "promise"}},
    {"hard_hand_over", {"request_removed"}},
    {"imprecise_causing", {"promise"}},
    {"incompatible_pushes", {"condition_tightened"}},
    {"needs_conflict", {"needs_removed", "needs_added"}},
    {"needs_cycle", {"needs_added"}},
    {"optional_never_runs", {"request_removed"}},
    {"overlapping_providers", {"condition_loosened"}},
    {"priority_without_effect", {"priority"}},
    {"push_cycle", {"promise", "condition_tightened"}},
    {"self_conflict", {"needs_added"}},
    {"state_without_source", {"state_source"}},
    {"stay_adds_nothing", {"condition_tightened"}},
    {"task_cycle", {"request_added"}},
    {"uncovered_state", {"provider_removed"}},
    {"undeclared_need", {"needs_removed"}},
    {"undeclared_state_write", {}},
    {"undone_by_expiry", {"condition_tightened"}},
    {"undone_by_fallback", {"needs_added"}},
    {"undone_by_itself", {"condition_tightened"}},
    {"undone_by_stop", {"condition_tightened"}},
    {"undone_in_turn", {"condition_tightened"}},
    {"unpushable_causing", {"push_lost"}},
    {"unreachable_case", {}},
    {"unreachable_causing", {"push_lost"}},
    {"unreachable_when", {"became_dead"}},
    {"unreserved_tasks", {"needs_removed"}},
    {"unused_allow", {"finding_new"}},
    {"unused_causing", {"promise"}},
    {"unused_need", {"request_removed"}},
    {"useless_use", {"uses"}},
    {"waiting_company", {"unit"}},
};

/// What one shape changes.
const std::map<std::pair<std::string, std::string>, Kinds> by_shape{
    {{"alternating_providers", "both by themselves"}, {"condition_loosened"}},
    {{"assertion_failed", "beats"}, {"assertion"}},
    {{"assertion_failed", "can_run"}, {"needs_added"}},
    {{"assertion_failed", "never_together"}, {"needs_added"}},
    {{"assertion_failed", "soft"}, {"condition_loosened"}},
    {{"equal_priority", "two apart"}, {"takeover_lost"}},
    {{"equal_priority", "two of a pack"}, {"takeover_lost"}},
    {{"equal_priority", "two purposes"}, {"takeover_lost", "condition_loosened"}},
    {{"equal_priority", "two roots"}, {"takeover_lost"}},
    {{"imprecise_causing", "says too little"}, {"push_lost"}},
    {{"needs_conflict", "twice"}, {"needs_removed"}},
    {{"optional_never_runs", "in each pack"}, {"request_added"}},
    {{"ordering_on_sentinel", "in a stay"}, {"condition_loosened"}},
    {{"ordering_on_sentinel", "in a when"}, {"group_added"}},
    {{"pack_conflict", "a skill and its part"}, {"request_added"}},
    {{"pack_conflict", "conditions"}, {"condition_tightened"}},
    {{"pack_conflict", "in a planner"}, {"request_added"}},
    {{"pack_conflict", "three for two"}, {"needs_added"}},
    {{"pack_conflict", "two skills of one part"}, {"request_added"}},
    {{"possible_pack_conflict", "a flat list"}, {"unit"}},
    {{"possible_pack_conflict", "only while"}, {"request_added"}},
    {{"possible_pack_conflict", "the preferred provider"}, {"unit"}},
    {{"push_held_by_outside", "the company chooses"}, {"unit"}},
    {{"push_held_by_outside", "the skill chooses"}, {"needs_added"}},
    {{"push_held_by_outside", "the task chooses"}, {"provider_added"}},
    {{"push_in_vain", "kept above"}, {"takeover_gained"}},
    {{"push_in_vain", "takes the group"}, {"takeover_gained"}},
    {{"push_in_vain", "takes the request"}, {"request_removed"}},
    {{"push_in_vain", "takes the state"}, {"sets"}},
    {{"push_inversion", "a root of its own"}, {"takeover_gained"}},
    {{"push_inversion", "somebody between"}, {"takeover_gained"}},
    {{"push_inversion", "something below"}, {"push_gained"}},
    {{"self_defeating_handler", "start"}, {"condition_tightened"}},
    {{"self_defeating_handler", "stop"}, {"handler"}},
    {{"shadowed_provider", "behind the last"}, {"provider_added"}},
    {{"shadowed_provider", "nothing left"}, {"became_dead"}},
    {{"shadowed_provider", "special after general"}, {"preference"}},
    {{"sibling_starvation", "the same group"}, {"request_added"}},
    {{"sibling_starvation", "what is below"}, {"unit"}},
    {{"starved_task", "always behind"}, {"request_removed"}},
    {{"starved_task", "further down"}, {"needs_added"}},
    {{"unbounded_choice", "members"}, {"provider_added"}},
    {{"unbounded_choice", "needs"}, {"group_added"}},
    {{"uncovered_state", "a gate"}, {"finding_new"}},
    {{"unpushable_causing", "below the task"}, {"push_lost"}},
    {{"unset_is_false", "at the start"}, {"condition_loosened"}},
    {{"unset_is_false", "expired"}, {"state_source"}},
    {{"unset_is_false", "in a stay"}, {"condition_loosened"}},
    {{"unused_declaration", "a group"}, {"became_dead"}},
    {{"unused_declaration", "a layer"}, {"group_removed"}},
    {{"unused_declaration", "a state"}, {"request_removed"}},
    {{"unused_declaration", "a trigger"}, {"group_removed"}},
    {{"yaml_word_trap", "a group"}, {"group_added"}},
    {{"yaml_word_trap", "a provider"}, {"provider_added"}},
    {{"yaml_word_trap", "a value"}, {"state_values"}},
};

} // namespace

const std::set<std::string>& expected_kinds(const Planter& planter) {
  static const Kinds refused{"refused"};
  if (refused_checks.count(planter.id) != 0) return refused;
  const auto shape = by_shape.find({planter.id, planter.shape});
  if (shape != by_shape.end()) return shape->second;
  const auto check = by_check.find(planter.id);
  if (check == by_check.end()) throw std::logic_error(std::string("no kind is expected for ") + planter.id);
  return check->second;
}

} // namespace director::defects
