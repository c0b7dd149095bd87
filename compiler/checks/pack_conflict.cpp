// Header: compiler/checks/check.hpp. Test: compiler/checks/pack_conflict.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/checks/check.hpp"

namespace director::checks {

void pack_conflict(const Input& input, Findings& findings) {
  for (const PackConflict& conflict : input.conflicts.pack_conflicts()) {
    if (input.model.providers[conflict.provider].has_packs)
      report_pack_conflict(input, input.shared.units(), conflict, findings);
  }
}

} // namespace director::checks
