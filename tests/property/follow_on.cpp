// Door: tests/property/verdicts.hpp. Test: tests/property/verdicts_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/facts.hpp"
#include "tests/property/verdicts.hpp"

namespace director::property {

FollowOn follow_on_of(const compiler::Model& model) {
  const compiler::Graph graph = compiler::make_graph(model);
  const analysis::Facts mended = analysis::find_facts(model, graph),
                        facts = analysis::find_facts(model, graph, analysis::Reported::as_is);
  FollowOn out;
  for (const compiler::ProviderId id : model.providers.ids()) {
    if (mended.active.contains(id) && !facts.active.contains(id)) out.idle.push_back(id);
    if (mended.pushed.contains(id) && !facts.pushed.contains(id)) out.unpushed.push_back(id);
  }
  return out;
}

} // namespace director::property
