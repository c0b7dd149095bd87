#pragma once
// SPDX-License-Identifier: MIT
// Finds the tasks that push nothing while something from outside is lacking, although a later choice needs only a push:
// of a refused unit the first combination counts whose groups are available, and if no provider promises one of its
// false conditions, the unit waits for the outside (semantics.md 4.4, "Refuse").

#include "compiler/analysis/input.hpp"

#include <vector>

namespace director::analysis {

/// A provider that promises a condition, but waits for an external state.
struct Hope {
  ProviderId causer{};
  ConditionUse outside{};
};

struct HeldPush {
  const Task* waits = nullptr; ///< the member of the unit that would push
  ProviderId waiter{};         ///< of the later choice; for the member, or for one of its needs
  ConditionUse wanted{};       ///< what it waits for
  ProviderId causer{};         ///< what it would push

  const Task* with = nullptr; ///< the member whose first choice lacks something from outside: the same, or another one
  ProviderId first{};         ///< the provider that lacks it
  ConditionUse outside{};     ///< what it lacks; no provider promises that, or those that do wait for the outside too
  std::vector<Hope> hopes;    ///< all that promise it, if any

  /// The first place where the two choices differ.
  ProviderId earlier{}, later{};
};

/// In the order of requests; each pair of conditions once.
std::vector<HeldPush> find_held_pushes(const Input& input);

} // namespace director::analysis
