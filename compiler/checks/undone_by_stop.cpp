// Header: compiler/checks/check.hpp. Test: compiler/checks/undone_by_stop.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/rounds/ended_requests.hpp"
#include "compiler/analysis/rounds/stop_rounds.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

namespace {

void report_ended(const Model& model, const EndedRequests& ended, Findings& findings) {
  const ConditionUse& entry = ended.entry;
  const StopValue& stop = ended.stop;
  const Condition& set = model.conditions[entry.id];
  const std::string condition = name_of(model, entry.id), requester = name_of(model, ended.requester);
  dsl::Diagnostic& finding = findings.add(
      stop.span, fmt::format("{}, and it is stopped when it has {} {}, which ends {}, which requests it: the two go "
                             "round",
                             stop.what, ended.promised ? "caused" : "set", condition, requester));
  finding.notes.push_back({entry.span, fmt::format("{} {} {}", name_of(model, ended.setter),
                                                   ended.promised ? "causes" : "may set", condition)});
  for (const compiler::Provider& provider : model.providers) {
    for (const ConditionUse& each : provider.when) {
      const Condition& waits = model.conditions[each.id];
      if (waits.state == set.state && waits.accepts.overlaps(set.accepts) && !waits.accepts.overlaps(stop.values))
        finding.rules_out.push_back(each.span);
    }
  }
  const std::vector<ConditionUse>& when = model.providers[ended.waits].when;
  const auto use = std::find_if(when.begin(), when.end(),
                                [&](const ConditionUse& each) { return model.conditions[each.id].state == set.state; });
  if (use != when.end()) finding.notes.push_back(runs_only_while(model, ended.waits, *use));
  const GroupId of = model.providers[ended.requester].group;
  add_chain(model, need_path(model, of, model.providers[ended.waits].group), finding.notes);
  if (const RequestEntry request = find_entry(model, ended.requester, ended.group); request.task != nullptr)
    finding.notes.push_back(requests(model, ended.requester, *request.task));
  if (ended.next) {
    finding.help = fmt::format("{}: {} can run with {}", stop.without, name_of(model, *ended.next), condition);
  } else {
    finding.help = use == when.end() ? "" : stay_help(model, of, {ended.waits, *use, {}}, set.accepts) + ", or ";
    finding.help += stop.without;
  }
}

void report_round(const Model& model, const StopRound& round, Findings& findings) {
  const Task* const refused = round.reason.refused;
  dsl::Diagnostic& finding = findings.add(
      round.stop.span, fmt::format("{}, and it is stopped when {}, which waits for {}: the two go round",
                                   round.stop.what, round.granted, name_of(model, round.want.condition.id)));
  add_taking(model, round.want, round.causer.note, round.reason.how, finding);
  finding.help = refused == nullptr ? "" : fmt::format("make {} `apart`, or ", name_of(model, refused->target));
  finding.help += stay_help(model, round.waits, round.want, round.values, round.timing);
}

} // namespace

void undone_by_stop(const Input& input, Findings& findings) {
  const IdTable<StateId, std::vector<GroupId>> stopping = find_stopping(input.model);
  const std::vector<EndedRequests> ended = find_ended_requests(input, stopping);
  for (const EndedRequests& each : ended) report_ended(input.model, each, findings);
  for (const StopRound& round : find_stop_rounds(input, stopping, ended)) report_round(input.model, round, findings);
}

} // namespace director::checks
