#pragma once
// SPDX-License-Identifier: MIT
// What is wrong in a behaviour, for its picture: what the Model could not take from the Spec, and findings, each at the
// box or the row that it is about.

#include "compiler/emit/graph/picture_options.hpp"
#include "compiler/model/model.hpp"
#include "dsl/diagnostic.hpp"
#include "dsl/source_file.hpp"
#include "dsl/spec.hpp"

#include <vector>

namespace director::compiler {

/// Names that mean nothing, and conditions in which something is wrong.
PictureFlaws find_missing(const dsl::Spec& spec, const Model& model, const dsl::Sources& sources,
                          const std::vector<dsl::Diagnostic>& findings);

/// All of them, each where it belongs.
void add_findings(PictureFlaws& flaws, const dsl::Spec& spec, const Model& model, const dsl::Sources& sources,
                  const std::vector<dsl::Diagnostic>& findings);

} // namespace director::compiler
