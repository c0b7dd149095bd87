#pragma once
// SPDX-License-Identifier: MIT
// Reports members of a unit that can never be granted together, for pack_conflict and possible_pack_conflict.

#include "compiler/checks/check.hpp"

namespace director::checks {

/// Reports what excludes what, down to the cause, at the last member: for named packs, or for flat lists.
void report_pack_conflicts(const Input& input, bool of_packs, Findings& findings);

} // namespace director::checks
