// Header: compiler/checks/code_check.hpp. Test: compiler/checks/missing_handler.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/code_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

void missing_handler(const CodeInput& input, Findings& findings) {
  const std::vector<CodeClass>& classes = input.code.classes;
  for (const CodeClass& each : classes) {
    // What a class leaves undefined, a derived class may define.
    const bool goes_on = input.code.continued.count(each.key) != 0 ||
                         std::any_of(classes.begin(), classes.end(), [&](const CodeClass& other) {
                           return std::find(other.bases.begin(), other.bases.end(), each.key) != other.bases.end();
                         });
    if (goes_on) continue;
    for (const std::string& context : each.missing) {
      const auto of = input.names.contexts.find(context);
      if (of == input.names.contexts.end()) continue;
      const BodyOf& body = of->second;
      dsl::Diagnostic& finding = findings.add(
          span_of(input.model, body), fmt::format("`{}` has no body for {}", each.name, name_of(input.model, body)));
      finding.notes.push_back({each.span, "the class is here"});
      finding.help = fmt::format("`{}`", declaration_of(body, context));
    }
  }
}

} // namespace director::checks
