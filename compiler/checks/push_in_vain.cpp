// Header: compiler/checks/check.hpp. Test: compiler/checks/push_in_vain.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/chains/sparse_set.hpp"
#include "compiler/analysis/clashes/exclusions.hpp"
#include "compiler/analysis/clashes/lost_steps.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/conflicts/kept_while_requested.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/uncovered/excluded_causers.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/proposals.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"
#include "compiler/checks/report_stranded_pushes.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace director::checks {

namespace {

void report_step(const Model& model, const LostStep& step, Findings& findings) {
  const GroupId group = model.providers[step.waiter].group;
  const StateId own = model.conditions[step.step.id].state;
  const std::string waiter = name_of(model, step.waiter), name = name_of(model, group), of = name_of(model, own);
  dsl::Diagnostic& finding =
      findings.add(step.condition.span, fmt::format("{} waits for {} in vain: while {} waits, {} is {} again", waiter,
                                                    name_of(model, step.condition.id), name, of,
                                                    model.states[own].value_text(*model.states[own].initial)));
  finding.notes.push_back(runs_only_while(model, step.waiter, step.step));
  finding.notes.push_back({model.states[own].of->span, fmt::format("{} begins again when {} stops", of, name)});
  finding.notes.push_back(causes(model, step.causer, step.condition.id));
  finding.help =
      fmt::format("let {} request a group that waits for {} instead", waiter, name_of(model, step.condition.id));
}

std::string loss_of(const Model& model, const Clash& clash) {
  const std::string causer = name_of(model, clash.second_causer);
  switch (clash.loss) {
  case Clash::Loss::request:
    return fmt::format("the request for {}", name_of(model, model.providers[clash.second_causer].group));
  case Clash::Loss::group: return fmt::format("a group that {} cannot do without", causer);
  case Clash::Loss::provider: return fmt::format("a state that {} cannot run without", causer);
  case Clash::Loss::held:
  case Clash::Loss::for_good: break;
  }
  return {};
}

/// The first one is the awaited condition.
std::string lost_with(const Model& model, const std::vector<ConditionId>& lost) {
  if (lost.size() == 1) return "it is lost: what could bring it back runs only while it holds";
  std::vector<std::string> names{"that"};
  for (std::size_t i = 1; i < lost.size(); ++i) names.push_back(name_of(model, lost[i]));
  return fmt::format("{} are lost: what could bring them back runs only while one of them holds", list_of(names));
}

std::string message_of(const Model& model, const Clash& clash) {
  const std::string waits =
      fmt::format("{} waits for {} in vain", name_of(model, clash.second_waiter), name_of(model, clash.second.id));
  if (clash.loss == Clash::Loss::for_good) return fmt::format("{} once {}", waits, lost_with(model, clash.lost));
  if (clash.loss == Clash::Loss::held)
    return fmt::format("{}: what {} needs is kept above it", waits, name_of(model, clash.second_causer));
  const std::string causer = name_of(model, clash.first_causer), first = name_of(model, clash.first.id);
  if (clash.member != nullptr)
    return fmt::format("{}: the push of {} for {}, which {} waits for, takes away {}", waits, causer, first,
                       name_of(model, clash.first_waiter), loss_of(model, clash));
  return fmt::format("{}: its push of {} for {} takes away {}", waits, causer, first, loss_of(model, clash));
}

std::string help_of(const Model& model, const Clash& clash) {
  const std::string first = name_of(model, clash.first_causer), second = name_of(model, clash.second_causer);
  const std::string group = name_of(model, model.providers[clash.second_causer].group);
  switch (clash.loss) {
  case Clash::Loss::request:
    // What it requests would never get what it keeps for itself.
    if (!clash.shares_group) return fmt::format("let {} request {} too", first, group);
    return "let one provider cause both";
  case Clash::Loss::group: return "let one provider cause both, or let one of the two do without what both take";
  case Clash::Loss::provider:
    return fmt::format("let {} leave that state as it is, or {} run without it{}", first, second,
                       put_last(model, clash.second_causer, [&](const ConditionUse& use) {
                         return sets_against(model, clash.first_causer, use).has_value();
                       }));
  case Clash::Loss::held:
    return fmt::format("let {} or what is above {} do without that", second, name_of(model, clash.task));
  case Clash::Loss::for_good:
    if (clash.unrequested)
      return fmt::format("let something that runs without {}, and ranks after {}, request {}",
                         name_of(model, clash.second.id), name_of(model, clash.task), group);
    if (!clash.lacking) return fmt::format("let {} run without what is lost then", second);
    return fmt::format(
        "let {} run without {}{}", second, name_of(model, *clash.lacking),
        put_last(model, clash.second_causer, [&](const ConditionUse& use) { return use.id == *clash.lacking; }));
  }
  return {};
}

void report_kept(const Model& model, const KeptWhileRequested& found, Findings& findings) {
  const auto& [request, want, one] = found;
  const ProviderId above = *request.requester, causer = want.causers.front();
  const std::string keeper = name_of(model, above), by = name_of(model, causer), group = name_of(model, one.group);
  dsl::Diagnostic& finding =
      findings.add(want.condition.span,
                   fmt::format("{} waits for {} in vain while {} keeps {}, which {} needs", name_of(model, want.waiter),
                               name_of(model, want.condition.id), keeper, group, by));
  finding.notes.push_back(causes(model, causer, want.condition.id));
  finding.notes.push_back(one.needed);
  finding.notes.push_back(one.kept);
  finding.notes.push_back(requests(model, above, *request.task));
  finding.help = fmt::format("let {} or {} do without {}", by, keeper, group);
}

/// Adds the request, and the nearest above it whose conditions are on the state.
void add_request(const Input& input, const Request& request, StateId state, std::vector<dsl::Note>& notes) {
  const Model& model = input.model;
  const PushExclusion& exclusion = input.shared.push_exclusion();
  std::vector<Request> open{request};
  SparseSet<GroupId> seen;
  for (std::size_t next = 0; next < open.size() && next < most_notes; ++next) {
    const Request at = open[next]; // the list grows
    if (!at.requester) continue;
    const GroupId above = model.providers[*at.requester].group;
    add_once(requests(model, *at.requester, *at.task), notes);
    if (!exclusion.conditions_on(state, *at.requester).empty()) {
      add_exclusion(model, exclusion, state, *at.requester, *at.requester, notes);
    } else if (seen.add(above)) {
      const std::vector<Request>& further = input.shared.requests().of(above);
      open.insert(open.end(), further.begin(), further.end());
    }
  }
}

void report_excluded_causers(const Input& input, const ExcludedCausers& found, Findings& findings) {
  using Excluded = ExcludedCausers::Excluded;
  const Model& model = input.model;
  const PushExclusion& exclusion = input.shared.push_exclusion();
  const auto& [want, request, region, all] = found;
  const Excluded& first = all.front();
  std::vector<std::string> names;
  for (const Excluded& each : all) {
    if (each.state == first.state && each.unrequested == first.unrequested)
      names.push_back(name_of(model, each.causer));
  }
  const ValueSet values = exclusion.values_of(first.state, want.waiter, region);
  const std::string wanted = name_of(model, want.condition.id);
  const std::string then =
      fmt::format("while {} is {}", name_of(model, first.state), values_in_words(model.states[first.state], values));
  dsl::Diagnostic& finding =
      findings.add(want.condition.span, fmt::format("{} waits for {} in vain {}: {}, which could cause it, {} then",
                                                    name_of(model, want.waiter), wanted, then, few_of(names),
                                                    !first.unrequested  ? "cannot run"
                                                    : names.size() == 1 ? "is not requested"
                                                                        : "are not requested"));
  for (const Excluded& each : all) {
    finding.notes.push_back(causes(model, each.causer, want.condition.id));
    add_exclusion(model, exclusion, each.state, want.waiter, each.causer, finding.notes);
    if (exclusion.conditions_on(each.state, want.waiter).empty())
      add_request(input, request, each.state, finding.notes);
    if (!each.unrequested) continue;
    for (const Request& other : input.shared.requests().of(model.providers[each.causer].group))
      add_request(input, other, each.state, finding.notes);
  }
  shorten(finding.notes);
  finding.help = first.unrequested ? fmt::format("let something request {} that runs {}",
                                                 name_of(model, model.providers[first.causer].group), then)
                                   : propose_causer(model, first.state, values, want.condition.id);
}

} // namespace

void push_in_vain(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const LostStep& step : find_lost_steps(input)) report_step(model, step, findings);
  for (const Clash& clash : input.conflicts.clashes()) {
    if (clash.kind != Clash::Kind::vain) continue;
    dsl::Diagnostic& finding = findings.add(clash.second.span, message_of(model, clash));
    add_parties(model, clash, finding);
    finding.help = help_of(model, clash);
  }
  for (const KeptWhileRequested& kept : find_kept_while_requested(input)) report_kept(model, kept, findings);
  for (const ExcludedCausers& causers : find_excluded_causers(input)) report_excluded_causers(input, causers, findings);
  report_stranded_pushes(input, findings);
}

} // namespace director::checks
