#pragma once
// SPDX-License-Identifier: MIT
// Finds what may withhold a group from a provider that requests it after it has begun: a task that meets it above, does
// not go after it, and may come to hold the group by a chain of its own.

#include "compiler/analysis/input.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "dsl/source/diagnostic.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

struct Contender {
  Meeting meeting;             ///< first: above the provider; second: above the contender
  std::vector<ChainStep> path; ///< from the second entry down to the group
};

/// The one with the shortest chain, of those that hold it while this provider can run.
std::optional<Contender> find_contender(const Input& input, ProviderId provider, GroupId group);

/// The notes: where they meet, and the chain.
void add_contender(const Model& model, const Contender& contender, GroupId group, dsl::Diagnostic& finding);

/// Its mandatory tasks that others may prevent although nothing can take its own needs away: each once, at its first
/// entry.
struct ContendedTask {
  const Task* task = nullptr;
  GroupId group{}; ///< the task's own, or one that it leads to
  Contender contender;
};
std::vector<ContendedTask> find_contended_tasks(const Input& input, ProviderId provider);

/// Whether something that the provider requests, or what is below that, may push the group, or what that has to have:
/// if the provider needed it, it could not.
bool is_pushed_below(const Input& input, const Provider& above, GroupId task);

/// Whether the provider may need it, without a conflict with what others or its own tasks want, and without waiting.
bool may_be_needed(const Input& input, ProviderId provider, const ContendedTask& contended);

/// Whether it matters that the group is stopped instead of handed over: it has a stop handler, or a provider that
/// promises something.
bool stop_matters(const Model& model, GroupId group);

/// A planner that is requested beside a task, goes before it, and may request something that the skill has to have, but
/// not the skill. Until it has decided, the task is given no skill that it does not have yet (semantics.md 4.4, "Defer"
/// and "Limbo"), so that a skill which passes to the task then is stopped in between.
struct Deferring {
  const Task* planner = nullptr;
  GroupId group{}; ///< what it may request
};
std::optional<Deferring> find_deferring(const Input& input, const Pack& pack, const Task& task, GroupId skill);

/// The first of its needs that it also requests as a mandatory task.
const Use<GroupId>* find_needed_task(const Model& model, const Provider& provider);

} // namespace director::analysis
