// Header: compiler/checks/code_check.hpp. Test: compiler/checks/pack_never_requested.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/code/code_words.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/code_check.hpp"

#include <fmt/format.h>

namespace director::checks {

void pack_never_requested(const CodeInput& input, Findings& findings) {
  const Model& model = input.model;
  for (const Body& body : input.bodies) {
    if (!body.of.provider || !body.is_whole() || only_keeps_going(body)) continue;
    for (const Pack& pack : model.providers[*body.of.provider].packs) {
      if (pack.name.empty() || requests_pack(body, pack)) continue;
      dsl::Diagnostic& finding =
          findings.add(pack.span, fmt::format("no path of {} requests `{}`", name_of(model, body.of), pack.name));
      finding.notes.push_back({body.function->span, "its body"});
      finding.help = "let the body request it, or leave it out of `packs`";
    }
  }
}

} // namespace director::checks
