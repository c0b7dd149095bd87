#pragma once
// SPDX-License-Identifier: MIT
// Finds values that a group sets without a promise and without a push, and that what is granted because of them undoes.

#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/input.hpp"
#include "dsl/source/diagnostic.hpp"

#include <optional>

namespace director::analysis {

/// A provider that makes a condition true, and how that is said.
struct Setting {
  ProviderId provider{};
  dsl::Note note;
};

class Settings {
public:
  explicit Settings(const Input& input)
      : model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        grants_(input.conflicts.grants()) {}

  /// Whether the task of this provider is granted alone, takes nothing with another provider, and may run.
  bool may_undo(ProviderId waiter) const {
    return may_be_granted_alone(model_.providers[waiter].group) && takes_all(waiter) && !never_runs(waiter);
  }
  /// Because of its conditions, or of what is held above it: other checks report that.
  bool never_runs(ProviderId id) const;
  /// Whether all that request the group need what the waiting provider needs.
  bool is_kept_off(ProviderId waiter, GroupId group) const;
  /// The first provider that the group chooses when the state has one of these values, with which the condition is
  /// false, or without `values` is unset, if that makes it true again.
  std::optional<Setting> find_setting(ProviderId waiter, const ConditionUse& use, GroupId group,
                                      const std::optional<ValueSet>& values) const;
  /// The same if the start of the group makes it true again, which runs when any provider of it is chosen.
  std::optional<Setting> find_start(ProviderId waiter, const ConditionUse& use, GroupId group,
                                    const ValueSet& values) const;

private:
  /// Otherwise what its unit lacks may be something else.
  bool may_be_granted_alone(GroupId task) const;
  /// Whether no other provider of the group takes anything.
  bool takes_all(ProviderId id) const;

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const Grants& grants_;
};

} // namespace director::analysis
