#pragma once
// SPDX-License-Identifier: MIT
// Reports a task that waits in vain because the provider that it pushes has lost a condition, for push_in_vain: the
// push stands, and serves what the task waits for, so that nothing is pushed for the lost one (semantics.md 4.4,
// "Refuse").

#include "compiler/checks/check.hpp"

namespace director::checks {

void report_stranded_pushes(const Input& input, Findings& findings);

} // namespace director::checks
