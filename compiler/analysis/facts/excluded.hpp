#pragma once
// SPDX-License-Identifier: MIT
// Finds the providers and tasks that never run because of the conditions of what is above them or beside them.

#include "compiler/analysis/facts/contexts.hpp"
#include "compiler/analysis/facts/facts.hpp"

namespace director::analysis {

/// Sets `excluded` and `excluded_tasks` of the facts; all others are found already.
void find_excluded(const Model& model, Contexts& contexts, Facts& facts);

} // namespace director::analysis
