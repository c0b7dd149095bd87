#pragma once
// SPDX-License-Identifier: MIT
// Explains what a push takes away from another provider, which is therefore pushed in vain: the places that show it.
// Empty: it takes nothing away.

#include "compiler/analysis/causing/wants.hpp"
#include "compiler/analysis/input.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "dsl/source/diagnostic.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

class Losses {
public:
  using Because = std::optional<std::vector<dsl::Note>>;

  Losses(const Model& model, const Graph& graph, const Facts& facts, const Shared& shared)
      : model_(model),
        graph_(graph),
        facts_(facts),
        shared_(shared),
        sources_(find_sources(model)) {}

  /// Only the group of `a` leads to that of `b`, and `a` does not.
  Because lost_request(ProviderId a, ProviderId b) const;
  /// The one holds what the other cannot run without, or both want the same group.
  Because lost_group(ProviderId a, ProviderId b) const;
  /// What the one sets makes a condition of the other false, and nothing else makes it true again while the task waits
  /// for what the other one causes.
  Because lost_provider(ProviderId a, ProviderId b, const Want& wanted) const;
  /// What `causer` needs is held by a group above the task.
  Because held_above(GroupId task, ProviderId causer) const;

  /// Whether the condition may become true without a push.
  bool comes_otherwise(const Want& want) const;

private:
  const Provider& row(ProviderId id) const { return model_.providers[id]; }
  /// Every provider of the group that leads to the task needs the other group.
  std::optional<dsl::Note> always_keeps(GroupId group, GroupId task, GroupId kept) const;
  bool comes_from_others(StateId state, const ValueSet& values, ProviderId but, const Want& wanted) const;
  /// Whether it, or its requester, runs only while the wanted condition holds, like the task itself.
  bool waits_too(ProviderId id, const Want& wanted) const;

  const Model& model_;
  const Graph& graph_;
  const Facts& facts_;
  const Shared& shared_;
  IdTable<StateId, std::vector<Source>> sources_;
};

} // namespace director::analysis
