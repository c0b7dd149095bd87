// Header: compiler/checks/code_check.hpp. Test: compiler/checks/task_never_requested.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/code/code_words.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/code_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

void task_never_requested(const CodeInput& input, Findings& findings) {
  const Model& model = input.model;
  for (const Body& body : input.bodies) {
    if (!body.of.provider || !body.is_whole() || body.is_unwritten() || only_keeps_going(body)) continue;
    for (const Pack& pack : model.providers[*body.of.provider].packs) {
      // If a whole pack is never requested, the pack is reported.
      if (!pack.name.empty() && !requests_pack(body, pack)) continue;
      for (const Task& task : pack.tasks) {
        const bool requested = std::any_of(body.possible.begin(), body.possible.end(), [&](const CodeWord* word) {
          const bool is_this_one = pack.name.empty() ? word->kind == CodeWord::Kind::request : is_pack(*word, pack);
          return is_this_one && gives(input, *word, task.target);
        });
        if (requested) continue;
        dsl::Diagnostic& finding = findings.add(
            task.span, fmt::format("no path of {} requests {}{}", name_of(model, body.of), name_of(model, task.target),
                                   pack.name.empty() ? "" : fmt::format(" with `{}`", pack.name)));
        finding.notes.push_back({body.function->span, "its body"});
        finding.help = fmt::format("let the body request it, or leave it out of {}",
                                   pack.name.empty() ? "`tasks`" : fmt::format("`{}`", pack.name));
      }
    }
  }
}

} // namespace director::checks
