// Header: compiler/checks/code_check.hpp. Test: compiler/checks/blocking_call.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/code_check.hpp"

#include <fmt/format.h>

#include <set>

namespace director::checks {

void blocking_call(const CodeInput& input, Findings& findings) {
  const Model& model = input.model;
  std::set<std::pair<const CodeBlock*, GroupId>> reported; // a function that several bodies of a group call
  for (const Body& body : input.bodies) {
    const Group& group = model.groups[body.of.group];
    if (!group.realtime) continue;
    for (const Blocked& blocked : body.blocks) {
      if (!reported.emplace(blocked.block, body.of.group).second) continue;
      dsl::Diagnostic& finding =
          findings.add(blocked.block->span, fmt::format("`{}` {}, and {} is `realtime`", blocked.block->name,
                                                        blocked.block->why, name_of(model, body.of.group)));
      finding.help = "leave it to a thread of its own, or leave out `realtime` if the body may wait";
      finding.notes.push_back({span_of(model, body.of), fmt::format("it runs in {}", name_of(model, body.of))});
      for (const CodeCall* call : blocked.chain)
        finding.notes.push_back({call->span, fmt::format("which calls `{}`", call->name)});
    }
  }
}

} // namespace director::checks
