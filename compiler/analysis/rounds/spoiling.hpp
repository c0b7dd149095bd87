#pragma once
// SPDX-License-Identifier: MIT
// Finds conditions of causing providers that a granted task makes false until it stops.

#include "compiler/analysis/input.hpp"
#include "compiler/analysis/rounds/granted.hpp"
#include "dsl/source/diagnostic.hpp"

#include <map>
#include <optional>
#include <vector>

namespace director::analysis {

/// Such a condition.
struct Spoilt {
  ConditionUse condition{};     ///< in the `when` of the causing provider
  ValueSet values;              ///< what its state has then
  std::vector<dsl::Note> notes; ///< what sets it, and what sets it back when the task stops
};

class Spoiling {
public:
  /// `granted` must outlive this. `runs`: the provider of the task.
  Spoiling(const Model& model, const Facts& facts, const Granted& granted, ProviderId runs)
      : model_(model),
        facts_(facts),
        granted_(granted),
        runs_(runs) {}

  /// The first one of this provider, of another state than `wanted`, with which it can neither begin nor continue.
  std::optional<Spoilt> of(ProviderId causer, ConditionId wanted) const;

private:
  /// What is set while the task runs.
  struct Entry {
    GroupId group{}; ///< the task, or one below it that stops with it
    ConditionUse set{};
    std::optional<ProviderId> by; ///< empty: its start
    bool promised = false;
  };
  void find_entries() const;
  void add(GroupId group, const std::vector<ConditionUse>& entries, std::optional<ProviderId> by, bool promised) const;
  dsl::Note note_of(const Entry& entry) const;
  void add_group(GroupId group, const Region& here, std::optional<ProviderId> runs) const;
  bool stops_with_task(GroupId group) const;

  const Model& model_;
  const Facts& facts_;
  const Granted& granted_;
  ProviderId runs_;
  mutable std::optional<std::map<StateId, std::vector<Entry>>> entries_; ///< first those of the task
};

} // namespace director::analysis
