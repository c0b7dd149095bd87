#pragma once
// SPDX-License-Identifier: MIT
// Conditions that a task waits for in vain: two of them, where a push for the one spoils the other, or one that never
// comes back.

#include "compiler/analysis/input.hpp"
#include "dsl/diagnostic.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

struct Clash {
  enum class Kind {
    incompatible, ///< two providers of one group, and each one's own conditions exclude what the other causes
    cycle,        ///< each is caused only by undoing the other; or one only while the other is false
    vain          ///< the push for the first one takes away what the second one's needs: see `loss`
  };
  enum class Loss {
    request,  ///< nothing else requests the group
    group,    ///< both want the same one
    provider, ///< it sets a state that the other one's conditions exclude
    held,     ///< what would be pushed needs what is kept above the task: `first` is `second`
    for_good  ///< what causes it runs only while it holds, or what may be lost with it: `first` is `second`
  };
  Kind kind = Kind::cycle;
  Loss loss = Loss::request;
  GroupId task{};
  ProviderId first_waiter{}, second_waiter{};
  ConditionUse first{}, second{};
  ProviderId first_causer{}, second_causer{};
  std::vector<ConditionId> lost;      ///< `for_good`: these together, the first is `second`
  std::optional<ConditionId> lacking; ///< `for_good`: of these, what the causer lacks then
  bool unrequested = false;           ///< `for_good`: nothing requests the causer then
  std::vector<dsl::Note> because;     ///< the places that show it
};

/// The first that applies, for each two conditions; each pair once, at the first task that waits for it.
std::vector<Clash> find_clashes(const Model& model, const Graph& graph, const Facts& facts, const Shared& shared);

/// Adds where both conditions stand and who causes them, and what shows the clash. The two never come true for the
/// task; nor does a push in vain come to anything.
void add_parties(const Model& model, const Clash& clash, dsl::Diagnostic& finding);

} // namespace director::analysis
