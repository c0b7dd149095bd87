#pragma once
// SPDX-License-Identifier: MIT
// Removes findings caused by unreadable text: a name that is declared there is not in the Spec, and seems to be
// undefined.

#include "dsl/source/diagnostic.hpp"
#include "dsl/source/source_file.hpp"

#include <vector>

namespace director::compiler {

/// The findings of resolve() without those that may be caused by an error of reading.
std::vector<dsl::Diagnostic> without_lost_names(const dsl::Sources& sources,
                                                const std::vector<dsl::Diagnostic>& reading,
                                                std::vector<dsl::Diagnostic> resolving);

} // namespace director::compiler
