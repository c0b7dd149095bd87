#pragma once
// SPDX-License-Identifier: MIT
// Findings as SARIF 2.1.0, for services that show them in a review. Source: the OASIS standard of that name.

#include "compiler/base/json.hpp"
#include "dsl/source/diagnostic.hpp"
#include "dsl/source/source_file.hpp"

#include <string>
#include <vector>

namespace director::compiler {

/// A rule in the list of rules: every check is one.
struct SarifRule {
  std::string id;
  dsl::Level level = dsl::Level::error;
  std::string summary; ///< a sentence
  std::string page;    ///< Markdown
};

/// How something may come about, in order.
struct SarifWitness {
  std::string message;
  std::vector<dsl::Note> steps; ///< the last one is the place of the message; not empty
};

/// `rules` in order of id; every finding's id is one of them. Columns count characters, as SARIF has it. A fingerprint
/// depends on the rule, the file, the text of the line and the message, but not on where the line is. `not_decided`:
/// what the run left open, a line each; it has no place, and so it is a notification of the run.
Json findings_sarif(const std::vector<dsl::Diagnostic>& findings, const std::vector<SarifWitness>& witnesses,
                    const dsl::Sources& sources, const std::vector<SarifRule>& rules,
                    const std::vector<std::string>& not_decided = {});

} // namespace director::compiler
