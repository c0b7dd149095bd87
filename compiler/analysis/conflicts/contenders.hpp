#pragma once
// SPDX-License-Identifier: MIT
// Who may keep a group from a provider that asks for it when it has begun: somebody who meets it above, does not go
// after it, and may come to hold the group by a chain of its own.

#include "compiler/analysis/input.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "dsl/diagnostic.hpp"

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

/// Its mandatory tasks that others may keep from it although nobody can take its own needs away: each once, as first
/// written.
struct ContendedTask {
  const Task* task = nullptr;
  GroupId group{}; ///< the task's own, or one that this comes down to
  Contender contender;
};
std::vector<ContendedTask> find_contended_tasks(const Input& input, ProviderId provider);

/// The first of its needs that is also a mandatory task of its.
const Use<GroupId>* find_needed_task(const Model& model, const Provider& provider);

} // namespace director::analysis
