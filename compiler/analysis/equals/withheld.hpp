#pragma once
// SPDX-License-Identifier: MIT
// Finds providers that their group does not change to, because a task of a less preferred provider of that group holds
// what they need, at equal rank: equals take nothing from each other (semantics.md, 4.2).

#include "compiler/analysis/chains/step.hpp"
#include "compiler/analysis/input.hpp"

#include <vector>

namespace director::analysis {

struct WithheldNeed {
  ProviderId wanting{};
  const Use<GroupId>* need = nullptr; ///< of `wanting`
  ProviderId running{};
  const Task* task = nullptr;  ///< of `running`
  GroupId group{};             ///< what both want: what is needed, or needed for it
  Level level{};               ///< of the task, with which it has the rank of the need
  std::vector<ChainStep> path; ///< from the task to what both want; empty: it is the task's own group
};

/// For each task the most preferred provider that it keeps waiting.
std::vector<WithheldNeed> find_withheld_needs(const Input& input);

} // namespace director::analysis
