#pragma once
// SPDX-License-Identifier: MIT
// Whether any task ever pushes a provider for a condition, directly or for another push (semantics.md 4.4, "Refuse").
// An over-approximation: what is not pushed here is never pushed.

#include "compiler/analysis/facts/pushes.hpp"
#include "compiler/analysis/facts/waiting.hpp"
#include "compiler/analysis/input.hpp"

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace director::analysis {

class Pushers {
public:
  explicit Pushers(const Input& input);

  /// Whether some task may push it for this condition, if none of another group is preferred.
  bool may_push(ProviderId causer, ConditionId condition);

  /// Another provider that causes the condition too, can be pushed whenever this one can, and then always is.
  std::optional<ProviderId> preferred(ProviderId causer, ConditionId condition);

private:
  struct Waiter {
    GroupId task{};
    bool idle = false; ///< some provider of it can never run
  };

  /// Requested groups whose conditions, or those of their needs, include this one.
  const std::vector<Waiter>& waiters(ConditionId condition);
  bool is_requested_after(ProviderId causer, ConditionId condition) const;
  bool is_sure(GroupId group) const;
  bool is_idle_pusher(const Waiter& waiter, ProviderId causer, ConditionId condition);
  bool is_pushed_in_chain(ProviderId causer, ConditionId condition);
  bool is_beside(const Waiter& waiter, ProviderId causer, ConditionId condition);

  bool comes_first(ProviderId rival, ProviderId causer, ConditionId condition);
  bool leads_to(GroupId group, GroupId task) const;
  bool is_free_for(ProviderId rival, ProviderId causer, ConditionId condition);

  const Input& input_;
  Waiting waiting_;
  Pushes pushes_;
  std::set<std::pair<ProviderId, ConditionId>> direct_;
  std::set<ConditionId> in_chains_; ///< of providers that may be pushed, and of their possible needs
  std::map<ConditionId, std::vector<Waiter>> waiters_;
};

} // namespace director::analysis
