#pragma once
// SPDX-License-Identifier: MIT
// Records what a scenario exercises while it is played.

#include "compiler/lower/lowered.hpp"
#include "compiler/play/coverage/coverage.hpp"
#include "compiler/play/onlooker.hpp"

#include <map>
#include <optional>

namespace director::compiler {

class CoverageWatch {
public:
  /// Keeps references to all of them. `coverage` is of that model.
  CoverageWatch(const Model& model, const Lowered& lowered, Coverage& coverage);
  CoverageWatch(const CoverageWatch&) = delete;
  CoverageWatch& operator=(const CoverageWatch&) = delete;

  Onlooker onlooker(); ///< for as long as this object exists

private:
  /// An edge of a chain, from an edge to one of root.
  using Chain = std::vector<Index>;

  struct Assignment {
    std::vector<Index> active, holders; ///< by group
    std::vector<bool> pushed;           ///< the same
    std::vector<Index> requests;        ///< by edge: its level
  };

  void mark(const CoveragePoint::Key& key);
  void ran(ProviderId provider, const Case* answer);
  void stepped(const Engine& engine);
  Assignment assignment(const Engine& engine) const;
  void look_at_levels(const director::State& state);
  void look_at_conditions(const Engine& engine);
  void mark_conditions(CoveragePoint::Kind kind, ProviderId provider, const std::vector<ConditionUse>& uses,
                       const Engine& engine);
  void look_at_pushes(const director::State& state);
  void look_at_take_overs(const Assignment& now, const Engine& engine);
  std::optional<Chain> chain(Index edge, const std::vector<Index>& holders) const;
  bool holds(ConditionId id, const Engine& engine) const;
  bool meets_conditions(ProviderId id, const Engine& engine) const;
  bool could_go_on(GroupId group, const Engine& engine, std::vector<GroupId>& above) const;
  bool optional_below(const Chain& chain, std::size_t sibling, const Assignment& now) const;
  void take_over(const Chain& taker, const Chain& loser, const Assignment& now, const Engine& engine);

  const Model& model_;
  const Lowered& lowered_;
  Coverage& coverage_;
  std::map<CoveragePoint::Key, std::size_t> places_;
  IdTable<GroupId, std::vector<GroupId>> needed_; ///< what a group's providers need, transitively, and itself
  Assignment before_;                             ///< after the micro-step before
};

} // namespace director::compiler
