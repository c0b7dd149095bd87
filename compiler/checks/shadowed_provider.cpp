// Door: compiler/checks/check.hpp. Test: compiler/checks/shadowed_provider.md.
#include "compiler/checks/analysis/facts/facts.hpp"
#include "compiler/checks/analysis/shared.hpp"
#include "compiler/checks/analysis/states/choice.hpp"
#include "compiler/checks/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

namespace director::checks {

namespace {

/// The rivals without which it would come first; all of them where each one is enough alone or none is.
std::vector<ProviderId> find_culprits(const Input& input, ProviderId id, const std::vector<ProviderId>& rivals) {
  for (const ProviderId rival : rivals) {
    if (!may_come_first(input.model, id, {rival}, input.facts.values, {})) return {rival};
  }
  return rivals;
}

/// Not for the sake of the earlier ones: what it waits for or needs never comes.
void report_never(const Input& input, ProviderId id, Findings& findings) {
  const std::string name = name_of(input.model, id);
  dsl::Diagnostic& finding = findings.add(input.model.providers[id].span, fmt::format("{} can never run", name));
  finding.notes = explain_idle(input, id);
  finding.help = fmt::format("request what brings that about, or leave {} out", name);
}

} // namespace

void shadowed_provider(const Input& input, Findings& findings) {
  const Model& model = input.model;
  const Facts& facts = input.facts;
  const Rivals& rivals = input.shared.rivals();
  IdSet<ProviderId> explained = input.shared.promises().explained;
  for (const Imprecise& fault : input.shared.imprecise()) explained.add(fault.causer);
  for (const ProviderId id : input.shared.promises().never_run) report_never(input, id, findings);
  for (const ProviderId id : model.providers.ids()) {
    const Provider& provider = model.providers[id];
    if (!facts.requested.contains(provider.group) || !facts.capable.contains(id) || facts.active.contains(id)) continue;
    if (explained.contains(id)) continue;
    std::vector<std::string> names;
    const std::vector<ProviderId> culprits = find_culprits(input, id, rivals.of(id));
    for (const ProviderId rival : culprits) names.push_back(name_of(model, rival));
    dsl::Diagnostic& finding = findings.add(
        provider.span,
        names.size() == 1
            ? fmt::format("{} never runs: {} comes before it and can run whenever it can", name_of(model, id), names[0])
            : fmt::format("{} never runs: {} come before it, and one of them can run whenever it can",
                          name_of(model, id), list_of(names)));
    for (const ProviderId rival : culprits)
      finding.notes.push_back({model.providers[rival].span, fmt::format("{} is preferred", name_of(model, rival))});
    finding.help = names.size() == 1 ? fmt::format("give {} a `when` that leaves something, or put it last", names[0])
                                     : "give one of them a `when` that leaves something, or put this one first";
  }
}

} // namespace director::checks
