#pragma once
// SPDX-License-Identifier: MIT
// Finds tasks that never get what is held above them, or by a task that is granted together with one above them.

#include "compiler/analysis/conflicts/grants.hpp"
#include "compiler/analysis/input.hpp"

#include <vector>

namespace director::analysis {

struct Loser {
  ProviderId above{};           ///< the owner of the pack
  const Task* entry = nullptr;  ///< of that pack: from there requests lead to the loser, or it is the loser itself
  Refused refused;              ///< the loser
  Taker taker;                  ///< `above`: that provider; else another entry of the pack
  std::vector<ChainStep> chain; ///< the requests from the pack to the loser
  /// It may run while another provider of the group keeps the requests of `above`, which does not hold as much.
  bool only_while_above = false;
};

/// For every pack, and any requester of its group; shorter chains first. Without those whose cause is further down.
std::vector<Loser> find_losers(const Input& input, Takers& takers, Packmates& packmates);

} // namespace director::analysis
