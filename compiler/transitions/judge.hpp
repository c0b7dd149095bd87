#pragma once
// SPDX-License-Identifier: MIT
// Classifies a play of both groups: soft, hard, replaced, and so on.

#include "compiler/transitions/player.hpp"
#include "compiler/transitions/words.hpp"

#include <cstdint>
#include <limits>
#include <set>
#include <vector>

namespace director::compiler::transitions {

class Judge {
public:
  Judge(const Model& model, const Lowered& lowered, const Player& player)
      : model_(model),
        lowered_(lowered),
        player_(player) {}

  /// `now`: the column runs.
  void judge(const Beginning& row, const Beginning& column, const Play& now, const Values& change, Transition& out,
             CellContext& context) const;

  /// Finds what stops on the row's side, and what runs on for others. Returns what no longer runs for the row's task.
  std::vector<GroupId> find_losses(const Beginning& row, const Beginning& column, const Trial& trial, Transition& out,
                                   CellContext& context) const;

  /// The pushes that were not made for the row's side.
  std::vector<Transition::Push> pushes_of(const Trial& trial, const Beginning& row) const;

private:
  struct Pushed {
    std::uint64_t micro_step = std::numeric_limits<std::uint64_t>::max();
    std::set<Index> groups; ///< empty: nothing is pushed
  };

  bool pushes(const Event& event, const Beginning& row) const;
  /// Adds the further conditions that were waited for until the column had what the row lost, and that the pushed
  /// providers promise: the engine makes no second push for them.
  void add_further(const Beginning& row, const Beginning& column, const Trial& trial, const Values& change,
                   const std::vector<GroupId>& lost, std::vector<Transition::Push>& pushes) const;
  /// The pushes for the column in the first micro-step that has any.
  Pushed first_pushes(const Beginning& row, const Trial& trial) const;
  bool pushed_first(const Beginning& row, const Beginning& column, const Trial& trial,
                    const std::vector<GroupId>& lost) const;
  bool runs_before(const Trial& trial, const Beginning& row, const Beginning& column) const;

  /// What those run now that needed what was taken.
  std::vector<ProviderId> instead_of_needing(const Beginning& row, const Rest& rest,
                                             const std::vector<GroupId>& taken) const;

  /// Adds the groups on the row's chain, below where the chains part, that have stopped; and finds which of them held
  /// what was taken, if that was nothing of the row's.
  void find_above(const Beginning& row, const Parting& parting, const Trial& trial, Transition& out,
                  CellContext& context) const;

  /// Finds what took from the row in place of the column; nothing if that was the column.
  void find_all_takers(const Beginning& row, const Beginning& column, const Trial& trial,
                       const std::vector<GroupId>& lost, const Transition& out, CellContext& context) const;

  /// Finds what was requested with the column and has what the row lost; nothing if the column has some of it.
  void find_takers(const Beginning& column, const Rest& rest, const std::vector<GroupId>& lost,
                   CellContext& context) const;

  /// Finds what ran for the column when it took something first; nothing if the column itself did so.
  void find_takers_below(const Beginning& row, const Beginning& column, const Trial& trial,
                         const std::vector<GroupId>& lost, CellContext& context) const;

  /// Finds what was requested with the column and pushed, and got with the push what the row has.
  void find_pushed_takers(const Beginning& row, const Beginning& column, const Trial& trial,
                          const std::vector<GroupId>& lost, CellContext& context) const;

  /// As the row began, with the holders after the micro-step.
  static Rest holders_after(const Beginning& row, const Trial& trial, std::uint64_t micro_step);
  /// The first moment when some of these groups, which run for the row's task, have a holder elsewhere.
  struct Taken {
    Rest when;              ///< with the holders of that moment
    std::vector<EdgeId> by; ///< the requests that hold them; empty: never
  };
  Taken first_taken(const Beginning& row, const Beginning& column, const Trial& trial,
                    const std::vector<GroupId>& groups) const;
  /// Whether anything of the row, or of what leads to it alone, had a holder elsewhere.
  bool takes_from_side(const Beginning& row, const Beginning& column, const Trial& trial) const;

  /// If nothing that the row lost, or that was interrupted, had another holder: what a body set that contradicts a
  /// condition of the row's side.
  std::optional<SetState> find_ender(const Beginning& row, const Beginning& column, const Trial& trial,
                                     const std::vector<GroupId>& lost, const Transition& out,
                                     const CellContext& context) const;

  const Model& model_;
  const Lowered& lowered_;
  const Player& player_;
};

} // namespace director::compiler::transitions
