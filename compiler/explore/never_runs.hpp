#pragma once
// SPDX-License-Identifier: MIT
// Reports what a complete exploration never reached, and cycles that any exploration saw, as findings. Their pages:
// compiler/checks/never_runs.md, never_at_rest.md.

#include "compiler/explore/search/search.hpp"
#include "compiler/model/model.hpp"
#include "dsl/source/diagnostic.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace director::compiler {

struct NeverRuns {
  std::vector<dsl::Diagnostic> findings; ///< never_at_rest, and never_runs unless something is open
  std::string open;                      ///< what was not tried, without a full stop; empty: everything was
};

/// Explores the behaviour, at most `bound` states of it. `findings`: earlier findings; neither what they report nor its
/// consequences are reported again. `progress` is called now and then.
NeverRuns find_never_runs(const Model& model, std::size_t bound, const std::vector<dsl::Diagnostic>& findings,
                          std::function<void(const SearchProgress& so_far)> progress = {});

} // namespace director::compiler
