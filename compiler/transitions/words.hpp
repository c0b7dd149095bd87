#pragma once
// SPDX-License-Identifier: MIT
// Describes a cell in sentences.

#include "compiler/transitions/matrix.hpp"
#include "compiler/transitions/trial.hpp"

namespace director::compiler::transitions {

/// The further input of the sentences.
struct CellContext {
  const Model& model;
  const TransitionMatrix::Row& row;
  const TransitionMatrix::Row& column;
  std::string why{};               ///< why the second does not run, from the engine
  std::string withdrawer{};        ///< the requester of both; empty: the program
  GroupId withdrawn{};             ///< replaced: what that one no longer requests, and leads to the first
  GroupId replacement{};           ///< likewise what it requests instead, and leads to the second
  std::vector<GroupId> others{};   ///< what was taken, and of what runs again that which does so for another requester
  std::vector<GroupId> left{};     ///< of these, those that do not run for the first one any more
  std::vector<GroupId> above{};    ///< of what stops, that which leads to the first one
  std::optional<GroupId> holder{}; ///< of the groups that lead to the first one, the lowest whose groups were taken;
                                   ///< empty: groups of the first one
  bool row_runs_on = false;        ///< condition lost: only groups below the first one are lost
  bool row_ended = false;          ///< waits, never: the first one stops when the second is requested
  bool takes_over = true;          ///< soft, hard: false: what stops runs again, or is not taken by anything
  bool is_requested = true;        ///< the second, while the first one runs
  std::vector<GroupId> takers{};   ///< soft, hard: what takes over in place of the second, and is requested with it
  bool is_below = false;           ///< the takers run for the second instead
  std::optional<GroupId> leader{}; ///< else: on the chain to the second, of which neither it nor what it requests takes
  std::vector<ProviderId> instead{};  ///< soft, hard: what runs in place of a provider whose needs were taken
  bool runs_at_once = false;          ///< with takers: the second does not wait
  std::vector<GroupId> round{};       ///< endless: what runs again and again
  bool when_done = false;             ///< endless: only when the first one is done
  std::optional<SetState> ender{};    ///< condition lost: what a body set; empty: the values from outside
  std::vector<SetState> set_states{}; ///< from the second one's request on
};

bool contains(const std::vector<GroupId>& groups, GroupId id);

std::string words_of(const Transition& cell, const CellContext& context);

/// `Phase == playing`
std::vector<std::string> words_of(const Values& values, const Model& model);

/// How the group is brought to run.
std::string words_of(const TransitionMatrix::Row& row, const Model& model);

} // namespace director::compiler::transitions
