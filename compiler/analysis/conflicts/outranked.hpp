#pragma once
// SPDX-License-Identifier: MIT
// Finds requests that may wait for a condition without pushing anything: the group that could cause it does not rank
// after what waits.

#include "compiler/analysis/input.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::analysis {

struct Outranked {
  ProviderId waiter{};
  ConditionUse condition{};
  std::vector<ProviderId> causers; ///< never empty
  const Task* request = nullptr;   ///< for the task that waits
  const Task* waits = nullptr;     ///< the same entry, or one above it
  const Task* first = nullptr;     ///< beside `waits`: leads to a causing group and does not rank after it
  /// Instead of `first`: the requester needs the causing group, so that nothing below it can push that.
  const Use<GroupId>* need = nullptr;
  std::optional<ProviderId> needer;
};

/// In order of waiter, condition and request. Without those whose condition may become true without that push.
std::vector<Outranked> find_outranked(const Input& input);

/// The help for it: what lets the waiting task go first.
std::string propose_going_first(const Model& model, const Outranked& one);

} // namespace director::analysis
