#pragma once
// SPDX-License-Identifier: MIT
// The list of checks in SARIF.

#include "compiler/emit/findings_sarif.hpp"

#include <vector>

namespace director::compiler::cli {

/// All of them, in order of id.
std::vector<SarifRule> sarif_rules();

} // namespace director::compiler::cli
