#pragma once
// SPDX-License-Identifier: MIT
// Reports what follows from all decisions together (compiler/analysis/decisions), as findings of existing checks: a
// provider that never runs is shadowed_provider, a task that is never granted starved_task or optional_never_runs, a
// pack that is never granted whole possible_pack_conflict. It runs last, for what none of them has a better reason for.

#include "compiler/checks/check.hpp"

#include <vector>

namespace director::checks {

/// `findings`: of all checks.
std::vector<dsl::Diagnostic> report_decisions(const Input& input, const std::vector<dsl::Diagnostic>& findings);

} // namespace director::checks
