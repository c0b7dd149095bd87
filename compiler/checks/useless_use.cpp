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
      if (std::any_of(edges.begin(), edges.end(), [&](EdgeId edge) { return model.edges[edge].target == use.id; }))
        continue;
      findings
          .add(use.span, fmt::format("{} neither requests nor needs {}: its run state is always `none`",
                                     name_of(model, provider.group), name_of(model, use.id)))
          .help = "a body sees the run states of its own tasks and needs, and of nothing else";
    }
  }
}

} // namespace director::checks
