// Door: compiler/checks/check.hpp. Test: compiler/checks/pack_conflict.md.
#include "compiler/checks/analysis/pack_conflicts.hpp"
#include "compiler/checks/check.hpp"

namespace director::checks {

void pack_conflict(const Input& input, Findings& findings) {
  Units units(input.model, input.facts);
  for (const PackConflict& conflict : find_pack_conflicts(input.model, units)) {
    if (input.model.providers[conflict.provider].has_packs) report_pack_conflict(input, units, conflict, findings);
  }
}

} // namespace director::checks
