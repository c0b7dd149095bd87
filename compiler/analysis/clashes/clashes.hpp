#pragma once
// SPDX-License-Identifier: MIT
// Finds conditions that a task waits for in vain: two of them, if a push for the one prevents the other, or one that
// never becomes true again.

#include "compiler/analysis/input.hpp"
#include "dsl/source/diagnostic.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

struct Clash {
  enum class Kind {
    incompatible, ///< two providers of one group, and each one's own conditions exclude what the other causes
    cycle,        ///< each is caused only by undoing the other; or one only while the other is false
    vain          ///< the push for the first one takes what the second one's providers need: see `loss`
  };
  enum class Loss {
    request,  ///< nothing else requests the group
    group,    ///< both want the same group
    provider, ///< it sets a state that the other one's conditions exclude
    held,     ///< the pushed provider would need what is held above the task: `first` is `second`
    for_good  ///< its causer runs only while it holds, or while conditions do that may be lost with it: `first` is
              ///< `second`
  };
  Kind kind = Kind::cycle;
  Loss loss = Loss::request;
  GroupId task{};
  const Task* member = nullptr; ///< the entry of the second waiter's task, if that is granted only together with `task`
  ProviderId first_waiter{}, second_waiter{};
  ConditionUse first{}, second{};
  ProviderId first_causer{}, second_causer{};
  std::vector<ConditionId> lost;      ///< `for_good`: these together, the first is `second`
  std::optional<ConditionId> lacking; ///< `for_good`: the one of these that the causer lacks then
  bool shares_group = false;          ///< `request`: both providers also want one group
  bool unrequested = false;           ///< `for_good`: nothing requests the causer then
  /// Both are caused by one group: whether the one may hold while the other one does not, without a push of this task.
  bool first_may_precede = true, second_may_precede = true;
  std::vector<dsl::Note> because; ///< the places that show it
};

/// The first kind that applies, for each two conditions of a task, or of two that a named pack requests together; each
/// pair once, at the first task that waits for it.
std::vector<Clash> find_clashes(const Model& model, const Graph& graph, const Facts& facts, const Shared& shared);

/// Adds where both conditions are declared, what causes them, and what shows the clash: they never become true together
/// for the task, and a push has no effect.
void add_parties(const Model& model, const Clash& clash, dsl::Diagnostic& finding);

} // namespace director::analysis
