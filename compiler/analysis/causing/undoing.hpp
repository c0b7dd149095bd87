#pragma once
// SPDX-License-Identifier: MIT
// Finds the values that make a condition of a running task false again.

#include "compiler/analysis/causing/wants.hpp"
#include "dsl/source/diagnostic.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::analysis {

/// Of `values` those with which the provider, chosen while its condition held, cannot continue: its `when` and its
/// `stay` are false, and it is not certain that another provider of its group can run then, as far as its conditions
/// say.
ValueSet undoing_values(const Model& model, ProviderId provider, ConditionId condition, const ValueSet& values);

/// When the value comes: before what the granted task requests is granted too, or later.
enum class Timing { with_grant, later };

/// The same of what a task for this group waits for: the `stay` of a group that it only needs then does not count; and
/// if the waiter is pushed, another provider of its group continues only if it causes the same.
ValueSet undoing_values(const Model& model, GroupId task, const Want& want, const ValueSet& values,
                        Timing timing = Timing::later);

/// The same for a state that becomes unset: whether the waiter cannot continue then.
bool is_undone_when_unset(const Model& model, GroupId task, const Want& want);

/// Of undoing values, those with which no other provider of the task can run either, without what this one needs.
ValueSet ending_values(const Model& model, GroupId task, const Want& want, const ValueSet& values,
                       Timing timing = Timing::later);

/// Of `values` of the state those with which none of these providers can run, where the conditions of `here` hold.
ValueSet without_other_ways(const Model& model, const std::vector<ProviderId>& others, StateId state, Region here,
                            ValueSet values);

/// Values that the stop of a group may give a state: by its handler, or because the state belongs to the group.
struct StopValue {
  ValueSet values;
  dsl::Span span{};
  std::string what;    ///< "the stop of `Walk` may set `Pose == lost`"
  std::string without; ///< how to do without it
};
std::vector<StopValue> stop_values(const Model& model, GroupId group, StateId state);
/// Of each state the groups whose stop may give it a value.
IdTable<StateId, std::vector<GroupId>> find_stopping(const Model& model);

/// Adds what the waiter runs for: its condition, and if it is pushed, for whom.
void add_waiter(const Model& model, const Want& want, std::vector<dsl::Note>& notes);

/// How the stop of the group makes the condition true.
std::optional<dsl::Note> stop_that_causes(const Model& model, GroupId group, ConditionId condition);

/// Whether what a task for this group waits for is granted with it, and runs: the task itself; later also a group that
/// it, or what it needs and requests, needs and requests in each pack. Else it is held only as a need.
bool is_granted_with(const Model& model, GroupId task, const Want& want, Timing timing = Timing::later);

/// "give `Kick` a `stay`", "let `Screw` request `Clamp` too, and give `Clamp` a `stay`"
std::string giving_stay(const Model& model, GroupId task, const Want& want);
/// Help for a wanted condition that these values make false again.
std::string stay_help(const Model& model, GroupId task, const Want& want, const ValueSet& values,
                      Timing timing = Timing::later);
/// The same for what the task waits for by itself.
std::string stay_help(const Model& model, const Want& want, const ValueSet& values);

} // namespace director::analysis
