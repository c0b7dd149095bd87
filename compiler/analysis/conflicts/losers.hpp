#pragma once
// SPDX-License-Identifier: MIT
// Who never gets what is held above it, or by the company of one that is above it.

#include "compiler/analysis/conflicts/grants.hpp"
#include "compiler/analysis/input.hpp"

#include <vector>

namespace director::analysis {

struct Loser {
  ProviderId above{};           ///< whose pack it is
  const Task* entry = nullptr;  ///< of that pack: from there requests lead to the loser, or it is the loser itself
  Refused refused;              ///< the loser
  Taker taker;                  ///< `above`: by that provider; else by another entry of the pack
  std::vector<ChainStep> chain; ///< the requests from the pack to the loser
};

/// Of every pack, whoever its group runs for; shorter chains first. Not what is the fault of somebody further down.
std::vector<Loser> find_losers(const Input& input, Takers& takers, Packmates& packmates);

} // namespace director::analysis
