#pragma once
// SPDX-License-Identifier: MIT
// Decides what blocks a task: whether it would be granted if one side held nothing.

#include "runtime/core/engine/engine.hpp"

namespace director::compiler {

enum class Blame {
  others, ///< nothing that the loser's side holds blocks the task, or those granted with it
  loser,  ///< without what the loser's side holds there would be a choice for all that are granted together
  shared  ///< the loser's side holds something, but others block as well; or the search was given up
};

/// `edge`: a blocked request of the winner's side.
Blame find_blame(const Engine& engine, Index edge, Index loser);

} // namespace director::compiler
