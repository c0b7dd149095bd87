#pragma once
// SPDX-License-Identifier: MIT
// Reports providers that never run for another reason than the earlier ones of their group, for shadowed_provider.

#include "compiler/analysis/conflicts/grants.hpp"
#include "compiler/checks/check.hpp"

namespace director::checks {

/// What it waits for or needs never comes.
void report_never(const Input& input, ProviderId id, Findings& findings);

/// It cannot run where its group is requested, and others of the group can.
void report_excluded(const Input& input, ProviderId id, Findings& findings);

/// What it needs is always held while others of its group can run.
void report_idle(const Input& input, ProviderId id, const Refused& refused, Findings& findings);

} // namespace director::checks
