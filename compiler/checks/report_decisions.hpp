#pragma once
// SPDX-License-Identifier: MIT
// What follows from all decisions together (compiler/analysis/decisions), in the words of the checks whose matter it
// is: a provider that never runs is shadowed_provider, a task that is never granted starved_task or
// optional_never_runs, a pack that is never granted whole possible_pack_conflict. It speaks last, of what none of them
// has a better reason for.

#include "compiler/checks/check.hpp"

#include <vector>

namespace director::checks {

/// `reported`: what all checks have found.
std::vector<dsl::Diagnostic> report_decisions(const Input& input, const std::vector<dsl::Diagnostic>& findings);

} // namespace director::checks
