// Header: compiler/checks/check.hpp. Test: compiler/checks/pack_conflict.md.
// SPDX-License-Identifier: MIT
#include "compiler/checks/check.hpp"
#include "compiler/checks/report_pack_conflicts.hpp"

namespace director::checks {

void pack_conflict(const Input& input, Findings& findings) { report_pack_conflicts(input, true, findings); }

} // namespace director::checks
