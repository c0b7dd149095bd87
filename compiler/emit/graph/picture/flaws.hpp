#pragma once
// SPDX-License-Identifier: MIT
// Faults of a behaviour, for its picture: what the Model could not take from the Spec, and findings, each at its box or
// row.

#include "compiler/emit/graph/picture/picture_options.hpp"
#include "compiler/model/model.hpp"
#include "dsl/source/diagnostic.hpp"
#include "dsl/source/source_file.hpp"
#include "dsl/spec.hpp"

#include <vector>

namespace director::compiler {

/// Finds unknown names, and conditions with faults.
PictureFlaws find_missing(const dsl::Spec& spec, const Model& model, const dsl::Sources& sources,
                          const std::vector<dsl::Diagnostic>& findings);

/// Adds all findings, each where it belongs.
void add_findings(PictureFlaws& flaws, const dsl::Spec& spec, const Model& model, const dsl::Sources& sources,
                  const std::vector<dsl::Diagnostic>& findings);

} // namespace director::compiler
