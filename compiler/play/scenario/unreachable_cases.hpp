#pragma once
// SPDX-License-Identifier: MIT
// Finds cases of a script that never apply: they look as if they tested something.

#include "compiler/model/model.hpp"
#include "dsl/scenario_spec.hpp"
#include "dsl/source/diagnostic.hpp"

#include <vector>

namespace director::compiler {

/// Adds a warning for each case of the entry that never applies. `providers`: those of the entry; none for a handler.
void find_unreachable_cases(const dsl::ScriptEntrySpec& entry, const std::vector<ProviderId>& providers,
                            const Model& model, std::vector<dsl::Diagnostic>& findings);

} // namespace director::compiler
