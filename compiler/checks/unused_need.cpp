// Header: compiler/checks/check.hpp. Test: compiler/checks/unused_need.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

namespace director::checks {

void unused_need(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const Provider& provider : model.providers) {
    for (const Use<GroupId>& need : provider.needs) {
      bool requested = need.id == provider.group; // needs_cycle reports that
      for (const EdgeId id : model.groups[provider.group].edges)
        requested = requested || (model.edges[id].target == need.id && !model.edges[id].levels.empty());
      if (requested) continue;
      findings
          .add(need.span, fmt::format("{} needs {} and never requests it", name_of(model, provider.group),
                                      name_of(model, need.id)))
          .help = "a need keeps others away; what should run for it has to be requested too, `apart` where it need not "
                  "wait for the others";
    }
  }
}

} // namespace director::checks
