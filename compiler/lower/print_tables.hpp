#pragma once
// SPDX-License-Identifier: MIT
// The tables as text: every row, with the names for its numbers.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"

#include <string>

namespace director::compiler {

/// The first part of what `directorc dump --stage=tables` prints.
std::string print_tables(const Model& model, const Lowered& lowered);

} // namespace director::compiler
