// Header: compiler/checks/check.hpp. Test: compiler/checks/sibling_starvation.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <set>
#include <tuple>
#include <utility>

namespace director::checks {

namespace {

void report(const Input& input, const Loser& loser, Findings& findings) {
  const Model& model = input.model;
  const Task &taker = *loser.taker.by, &sibling = *loser.taker.over;
  const GroupId group = loser.taker.group;
  const std::string name = name_of(model, taker.target), other = name_of(model, sibling.target);
  const Refused& lost = loser.refused;
  // Where the loser has a chance elsewhere, or for a moment, nothing is said of never.
  const bool never = input.conflicts.grants().refused().count(lost.task->edge) != 0;
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
  chain.erase(chain.begin()); // a note stands there
  for (const ChainStep& step : need_path(model, loser.refused.task->target, group)) chain.push_back(step);
  add_chain(model, chain, finding.notes);
  finding.help = fmt::format("make {} `apart` or `optional`, or ask for it one level lower", name);
}

} // namespace

void sibling_starvation(const Input& input, Findings& findings) {
  // The nearest one that loses stands for all that is below the same sibling.
  std::set<std::tuple<const Task*, const Task*, GroupId>> told;
  for (const Loser& loser : input.conflicts.losers()) {
    if (loser.taker.kind == Taker::Kind::unit &&
        told.emplace(loser.taker.by, loser.taker.over, loser.taker.group).second)
      report(input, loser, findings);
  }
}

} // namespace director::checks
