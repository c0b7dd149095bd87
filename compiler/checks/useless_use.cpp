// Header: compiler/checks/check.hpp. Test: compiler/checks/useless_use.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

void useless_use(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const Provider& provider : model.providers) {
    const std::vector<EdgeId>& edges = model.groups[provider.group].edges;
    for (const Use<GroupId>& use : provider.uses) {
      const auto at =
          std::find_if(edges.begin(), edges.end(), [&](EdgeId edge) { return model.edges[edge].target == use.id; });
      const bool needed = at != edges.end();
      if (needed && !model.edges[*at].levels.empty()) continue;
      const std::string group = name_of(model, provider.group), used = name_of(model, use.id);
      dsl::Diagnostic& finding = findings.add(
          use.span, needed
                        ? fmt::format("{} needs {} and never requests it: its run state is always `none`", group, used)
                        : fmt::format("{} neither requests nor needs {}: its run state is always `none`", group, used));
      finding.help = needed ? fmt::format("request {} too, or leave it out here", used)
                            : "a body sees the run states of its own tasks, and of nothing else";
    }
  }
}

} // namespace director::checks
