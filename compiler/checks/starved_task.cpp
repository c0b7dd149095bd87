// Header: compiler/checks/check.hpp. Test: compiler/checks/starved_task.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/checks/check.hpp"
#include "compiler/checks/report_starving_task.hpp"

namespace director::checks {

void starved_task(const Input& input, Findings& findings) {
  for (const StarvingTask& starving : input.conflicts.starving_tasks()) {
    if (!starving.optional) report_starving_task(input, starving, findings);
  }
}

} // namespace director::checks
