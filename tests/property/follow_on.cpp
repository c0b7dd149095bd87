// Door: tests/property/verdicts.hpp. Test: tests/property/verdicts_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/decisions/decisions.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include <cstdlib>
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
  if (!std::getenv("NOFOLLOW")) for (const auto how : {analysis::Reported::as_is}) {
    const auto& f = how == analysis::Reported::mended ? mended : facts;
    analysis::Budget budget;
    const auto d = analysis::find_decisions(model, f, how, budget);
    for (const compiler::ProviderId id : model.providers.ids()) {
      if (!d.decided.contains(model.providers[id].group)) continue;
      if (!d.runs.contains(id)) out.idle.push_back(id);
      for (std::size_t i = 0; i < model.providers[id].packs.size(); ++i)
        if (!d.whole.contains({id, i})) out.p_whole.emplace_back(id, i);
      for (const auto c : model.conditions.ids())
        if (!d.pushed.contains({id, c})) out.p_pushed.emplace_back(id, c);
    }
    for (const compiler::EdgeId id : model.edges.ids())
      if (d.decided.contains(model.edges[id].target) && !d.granted.contains(id)) out.p_granted.push_back(id);
  }
  return out;
}

} // namespace director::property
