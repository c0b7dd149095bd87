// Header: compiler/checks/code_check.hpp. Test: compiler/checks/stale_generated.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/code_check.hpp"

#include <fmt/format.h>

namespace director::checks {

void stale_generated(const CodeInput& input, Findings& findings) {
  for (const GeneratedHeader& header : input.code.headers) {
    if (header.fresh) continue;
    dsl::Diagnostic& finding =
        findings.add(input.model.name_span,
                     "the C++ was compiled with what another version of this behaviour, or of directorc, generated");
    finding.notes.push_back({{header.file, 0, 0}, "the generated header"});
    finding.help = "build it again, or `directorc generate`";
  }
}

} // namespace director::checks
