#pragma once
// SPDX-License-Identifier: MIT
// Who blocks a task: whether it would be granted if one side held nothing.

#include "runtime/core/engine/engine.hpp"

namespace director::compiler {

enum class Blame {
  others, ///< nothing that the loser's side holds is in the way of the task, or of those granted with it
  loser,  ///< without what the loser's side holds there would be a choice for all that are granted together
  shared  ///< the loser's side holds something, but others are in the way as well; or that took too long to find out
};

/// `edge`: a blocked request of the winner's side.
Blame find_blame(const Engine& engine, Index edge, Index winner, Index loser);

} // namespace director::compiler
