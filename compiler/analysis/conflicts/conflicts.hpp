#pragma once
// SPDX-License-Identifier: MIT
// Mutual exclusions that several checks use: computed on first use and kept for the run, like Shared, from which they
// follow.

#include "compiler/analysis/clashes/clashes.hpp"
#include "compiler/analysis/conflicts/grants.hpp"
#include "compiler/analysis/conflicts/held_pushes.hpp"
#include "compiler/analysis/conflicts/losers.hpp"
#include "compiler/analysis/conflicts/outranked.hpp"
#include "compiler/analysis/conflicts/pack_conflicts.hpp"
#include "compiler/analysis/conflicts/starving.hpp"
#include "compiler/analysis/conflicts/task_cycles.hpp"
#include "compiler/analysis/input.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

class Conflicts {
public:
  Conflicts(const Model& model, const Graph& graph, const Facts& facts, const Shared& shared)
      : input_{model, graph, facts, shared, *this} {}
  Conflicts(const Conflicts&) = delete;
  Conflicts& operator=(const Conflicts&) = delete;

  /// The input of the checks.
  const Input& input() const { return input_; }

  const std::vector<Clash>& clashes() const;
  /// Of all packs and flat lists.
  const std::vector<PackConflict>& pack_conflicts() const;
  const std::vector<TaskCycle>& task_cycles() const;
  /// Whether it leads back to a group that is always above it: the finding about the cycle reports that it is never
  /// granted.
  bool closes_cycle(EdgeId edge) const;
  Takers& takers() const;
  /// Below all roots.
  const Grants& grants() const;
  const std::vector<Loser>& losers() const;
  const std::vector<StarvingTask>& starving_tasks() const;
  const std::vector<Outranked>& outranked() const;
  const std::vector<HeldPush>& held_pushes() const;

private:
  Input input_;
  mutable std::optional<std::vector<Clash>> clashes_;
  mutable std::optional<std::vector<PackConflict>> pack_conflicts_;
  Packmates& packmates() const;

  mutable std::optional<std::vector<TaskCycle>> task_cycles_;
  mutable std::optional<Takers> takers_;
  mutable std::optional<Packmates> packmates_;
  mutable std::optional<Grants> grants_;
  mutable std::optional<std::vector<Loser>> losers_;
  mutable std::optional<std::vector<StarvingTask>> starving_tasks_;
  mutable std::optional<std::vector<Outranked>> outranked_;
  mutable std::optional<std::vector<HeldPush>> held_pushes_;
};

} // namespace director::analysis
