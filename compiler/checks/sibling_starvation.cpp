// Header: compiler/checks/check.hpp. Test: compiler/checks/sibling_starvation.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/requests/company.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace director::checks {

namespace {

/// Whether no request for it is ever granted, by what goes before it, or by all decisions together.
bool never_runs(const Input& input, EdgeId edge) {
  return input.conflicts.grants().refused().count(edge) != 0 ||
         input.shared.decisions().never_granted(input.model, edge);
}

/// Whether each provider that requests the loser needs what is taken: while the taker holds it, none of them runs, so
/// that nothing requests the loser.
bool needs_it_too(const Model& model, const Loser& loser) {
  const std::vector<ProviderId>& all = model.groups[*loser.refused.requester].providers;
  return std::all_of(all.begin(), all.end(), [&](ProviderId id) {
    const Provider& provider = model.providers[id];
    const auto requests_it = [&](const Pack& pack) { return pack.requests(loser.refused.task->edge); };
    return provider.needs_group(loser.taker.group) ||
           std::none_of(provider.packs.begin(), provider.packs.end(), requests_it);
  });
}

/// The help. As a unit of its own, the taking task must also go after the task that leads to the loser.
std::string propose(const Input& input, const Loser& loser) {
  const Model& model = input.model;
  const Task &taker = *loser.taker.by, &sibling = *loser.taker.over;
  const bool optional = std::any_of(loser.chain.begin(), loser.chain.end(), [&](const ChainStep& step) {
    const std::vector<EdgeId>& edges = model.groups[step.to].requesters;
    return std::any_of(edges.begin(), edges.end(), [&](EdgeId id) {
      return model.edges[id].requester == step.from && !model.edges[id].has_mandatory();
    });
  });
  std::string unit = optional ? "`optional`" : "`apart` or `optional`";
  const bool goes_first = Company::goes_first(model, taker, sibling);
  if (goes_first)
    unit = fmt::format("{} with a lower priority than {}", optional ? "`optional`," : "`optional`, or `apart`",
                       name_of(model, sibling.target));
  return fmt::format(
      "make {} {}, or request it one level lower{}", name_of(model, taker.target), unit,
      goes_first ? fmt::format(", by something with a lower priority than {}", name_of(model, sibling.target)) : "");
}

/// If the loser is granted elsewhere, or for a moment, the message does not claim "never". `more`: others that take
/// from the same one.
void report(const Input& input, const Loser& loser, bool never, const std::vector<const Loser*>& more,
            Findings& findings) {
  const Model& model = input.model;
  const Task &taker = *loser.taker.by, &sibling = *loser.taker.over;
  const GroupId group = loser.taker.group;
  const std::string name = name_of(model, taker.target), other = name_of(model, sibling.target);
  const Refused& lost = loser.refused;
  dsl::Diagnostic& finding = findings.add(
      taker.span, fmt::format("{} {} before anything below {} is tried{}", name,
                              group == taker.target ? "is granted" : "takes " + name_of(model, group), other,
                              never ? fmt::format(": {} never runs for {}", name_of(model, lost.task->target),
                                                  name_of(model, *lost.requester))
                                    : ", which wants it too"));
  if (never) finding.rules_out = {lost.task->span};
  finding.notes.push_back({sibling.span, fmt::format("{} is granted together with {}", other, name)});
  add_chain(model, need_path(model, taker.target, group), finding.notes);
  std::vector<ChainStep> chain = loser.chain;
  chain.erase(chain.begin()); // a note has that place
  for (const ChainStep& step : need_path(model, loser.refused.task->target, group)) chain.push_back(step);
  add_chain(model, chain, finding.notes);
  for (const Loser* each : more) {
    const Taker& one = each->taker;
    const std::string by = name_of(model, one.by->target);
    finding.notes.push_back(
        {one.by->span, one.group == one.by->target
                           ? fmt::format("the same here, by {}", by)
                           : fmt::format("the same here, by {}, which takes {}", by, name_of(model, one.group))});
  }
  finding.help = propose(input, loser);
}

} // namespace

void sibling_starvation(const Input& input, Findings& findings) {
  // The nearest loser represents all that are below the same sibling.
  std::set<std::tuple<const Task*, const Task*, GroupId>> reported;
  // That one never runs is reported once, for all takers.
  std::map<EdgeId, std::vector<const Loser*>> lost;
  std::vector<const Loser*> all;
  for (const Loser& loser : input.conflicts.losers()) {
    const Taker& taker = loser.taker;
    const EdgeId edge = loser.refused.task->edge;
    if (taker.kind != Taker::Kind::unit || input.facts.excludes(edge)) continue;
    if (needs_it_too(input.model, loser)) continue;
    if (!reported.emplace(taker.by, taker.over, taker.group).second) continue;
    const bool never = never_runs(input, edge);
    if (!never || lost.count(edge) == 0) all.push_back(&loser);
    if (never) lost[edge].push_back(&loser);
  }
  for (const Loser* loser : all) {
    const auto at = lost.find(loser->refused.task->edge);
    if (at == lost.end())
      report(input, *loser, false, {}, findings);
    else
      report(input, *loser, true, {at->second.begin() + 1, at->second.end()}, findings);
  }
}

} // namespace director::checks
