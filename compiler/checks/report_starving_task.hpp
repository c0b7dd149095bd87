#pragma once
// SPDX-License-Identifier: MIT
// Reports a task that never runs for its requester, for starved_task and optional_never_runs.

#include "compiler/analysis/conflicts/starving.hpp"
#include "compiler/checks/check.hpp"

namespace director::checks {

void report_starving_task(const Input& input, const StarvingTask& starving, Findings& findings);

} // namespace director::checks
