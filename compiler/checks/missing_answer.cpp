// Header: compiler/checks/code_check.hpp. Test: compiler/checks/missing_answer.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/code_check.hpp"

#include <fmt/format.h>

#include <set>

namespace director::checks {

void missing_answer(const CodeInput& input, Findings& findings) {
  std::set<const CodeFunction*> reported; // a function that several bodies call
  for (const Body& body : input.bodies) {
    for (const CodeFunction* function : body.open_ends) {
      if (!reported.insert(function).second) continue;
      const bool is_body = function == body.function;
      const std::string name = is_body ? name_of(input.model, body.of) : fmt::format("`{}`", function->name);
      dsl::Diagnostic& finding =
          findings.add(*function->open_end, fmt::format("{} may end here without an answer", name));
      finding.notes.push_back(
          {span_of(input.model, body.of), fmt::format("{} is here", name_of(input.model, body.of))});
      if (!is_body) finding.notes.push_back({body.function->span, "its body calls it"});
      finding.help = "end it with an answer: `return run.keep();`, or another one";
    }
  }
}

} // namespace director::checks
