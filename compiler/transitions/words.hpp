#pragma once
// SPDX-License-Identifier: MIT
// A cell in sentences.

#include "compiler/transitions/matrix.hpp"

namespace director::compiler::transitions {

/// What the sentences speak of, beside the cell itself.
struct CellContext {
  const Model& model;
  const TransitionMatrix::Row& row;
  const TransitionMatrix::Row& column;
  std::string why;          ///< why the second does not run, from the engine
  std::string withdrawer;   ///< who asks for both; empty: the program
  bool is_requested = true; ///< for the second, while the first one runs, or for what leads to it
};

std::string words_of(const Transition& cell, const CellContext& context);

/// `Phase == playing`
std::vector<std::string> words_of(const Values& values, const Model& model);

/// How the group is brought to run.
std::string words_of(const TransitionMatrix::Row& row, const Model& model);

} // namespace director::compiler::transitions
