#pragma once
// SPDX-License-Identifier: MIT
// The tables as text for people: every row, with the names that its numbers stand for, and the static priority table.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"

#include <string>

namespace director::compiler {

/// What `directorc dump --stage=tables` prints.
std::string print_tables(const Model& model, const Lowered& lowered);

/// Its last part: for each requester its edge levels, ranked; for each group that several edges lead to every pair of
/// these edges, with the common requester that decides between them.
std::string print_priorities(const Model& model);

} // namespace director::compiler
