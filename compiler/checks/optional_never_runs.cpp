// Door: compiler/checks/check.hpp. Test: compiler/checks/optional_never_runs.md.
#include "compiler/checks/analysis/shared.hpp"
#include "compiler/checks/check.hpp"

namespace director::checks {

void optional_never_runs(const Input& input, Findings& findings) {
  for (const StarvingTask& starving : input.shared.starving_tasks()) {
    if (starving.optional) report_starving_task(input, starving, findings);
  }
}

} // namespace director::checks
