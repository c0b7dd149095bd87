#pragma once
// SPDX-License-Identifier: MIT
// Runs every check, and decides what of all findings is reported, and as what.

#include "compiler/checks/check.hpp"

#include <set>

namespace director::checks {

/// What the user wants to be told.
struct Selection {
  bool only_errors = false;                              ///< others are not looked for
  bool every_lint = false;                               ///< `--lint`
  std::set<std::string, std::less<>> lints;              ///< `--lint=<id>`
  bool every_warning_is_error = false;                   ///< `--werror`
  std::set<std::string, std::less<>> warnings_as_errors; ///< `--werror=<id>`
  std::set<std::string, std::less<>> allowed;            ///< `--allow=<id>`: not reported, unless it is an error
};

/// Everything that the checks find, sorted by place; nothing suppressed. Of the lints only those that are asked for, or
/// that an `allow` names; only the errors, if that is asked for.
std::vector<dsl::Diagnostic> run_checks(const Model& model, const Graph& graph, const Facts& facts,
                                        const Selection& selection);

/// Drops what an `allow` covers. With `all_checks_ran`, an `allow` that covered nothing is a finding of its own;
/// without, it may be meant for a check that did not come to its turn.
std::vector<dsl::Diagnostic> apply_allowances(const Model& model, std::vector<dsl::Diagnostic> findings,
                                              bool all_checks_ran);

/// Drops what is allowed and lints that were not asked for, makes warnings errors as asked, and leaves of many notes
/// those that one reads.
std::vector<dsl::Diagnostic> apply_selection(const Selection& selection, std::vector<dsl::Diagnostic> findings);

} // namespace director::checks
