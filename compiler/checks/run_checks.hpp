#pragma once
// SPDX-License-Identifier: MIT
// Runs every check, and decides which findings are reported, and at which level.

#include "compiler/checks/check.hpp"

#include <set>

namespace director::checks {

/// The user's choice of findings.
struct Selection {
  bool only_errors = false;                              ///< others are not searched
  bool every_lint = false;                               ///< `--lint`
  std::set<std::string, std::less<>> lints;              ///< `--lint=<id>`
  bool every_warning_is_error = false;                   ///< `--werror`
  std::set<std::string, std::less<>> warnings_as_errors; ///< `--werror=<id>`; lints too
  std::set<std::string, std::less<>> allowed;            ///< `--allow=<id>`: not reported, unless it is an error
};

/// Everything that the checks find, sorted by place; nothing suppressed. Lints only if they are requested or an `allow`
/// names them; only the errors, if `only_errors`.
std::vector<dsl::Diagnostic> run_checks(const Model& model, const Graph& graph, const Facts& facts,
                                        const Selection& selection);

struct Sifted {
  std::vector<dsl::Diagnostic> reported; ///< sorted by place
  std::vector<dsl::Diagnostic> allowed;  ///< what an `allow` covers
};

/// With `all_checks_ran`, an `allow` that covered nothing is a finding of its own; otherwise it may be meant for a check
/// that did not run.
Sifted apply_allowances(const Model& model, std::vector<dsl::Diagnostic> all, bool all_checks_ran);

/// Drops what is allowed and lints that were not requested, makes warnings errors as requested, and limits the number
/// of notes.
std::vector<dsl::Diagnostic> apply_selection(const Selection& selection, std::vector<dsl::Diagnostic> findings);

} // namespace director::checks
