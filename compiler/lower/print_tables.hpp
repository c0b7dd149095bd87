#pragma once
// SPDX-License-Identifier: MIT
// The tables as text: every row, with the names for its numbers, and the static priority table.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"

#include <string>

namespace director::compiler {

/// What `directorc dump --stage=tables` prints.
std::string print_tables(const Model& model, const Lowered& lowered);

/// Its last part: for each requester its edge levels, ranked; for each group with several edges every pair of them,
/// with the common requester that decides between them.
std::string print_priorities(const Model& model);

} // namespace director::compiler
