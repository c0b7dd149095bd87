// Header: compiler/analysis/rounds/stopping_groups.hpp. Test: compiler/checks/undone_by_stop.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/rounds/stopping_groups.hpp"

#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/notes.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace director::analysis {

namespace {

class StoppedSearch {
public:
  StoppedSearch(const Input& input, const Granted& granted, ProviderId causer)
      : model_(input.model),
        facts_(input.facts),
        shared_(input.shared),
        granted_(granted),
        causer_(causer) {}

  /// Empty: the group continues, or is handed over, or it is not certain.
  std::optional<Taking> why_stopped(GroupId group) {
    if (granted_.below.contains(group)) return std::nullopt;
    if (granted_.is_other() && shared_.claims(granted_.waits).contains(group)) return std::nullopt;
    if (!is_requested_beside(shared_, granted_, group)) return std::nullopt;
    // It is held only as a need then, and a group that is not requested stops.
    if (granted_.takings.takes(group)) return granted_.takings.way_to(group);
    if (std::optional<Taking> out = why_needs_fail(model_, facts_, granted_.takings, group, causer_)) return out;
    return why_unrequested(group);
  }

  /// Requests whose unit is blocked, though their provider goes on.
  const std::vector<const Task*>& refused() const { return refused_; }

private:
  /// How everything that requests the group is stopped, and with it the group, described for the first one.
  std::optional<Taking> why_unrequested(GroupId group) {
    if (stopped_.count(group) != 0) return Taking{}; // it is described already
    if (!seen_.insert(group).second) return std::nullopt;
    std::optional<Taking> out;
    for (const EdgeId id : model_.groups[group].requesters) {
      const Edge& edge = model_.edges[id];
      if (edge.levels.empty()) continue;
      if (!edge.requester) return std::nullopt;
      if (!may_request(*edge.requester, group)) continue;
      std::optional<Taking> why = why_requester_stopped(*edge.requester);
      const bool stops = why.has_value();
      if (!why) why = why_units_end(id);
      if (!why) return std::nullopt;
      if (out) continue;
      out = std::move(why);
      if (!stops) continue; // the requester goes on
      const std::vector<ChainStep> step{{*edge.requester, group, false, request_span(model_, *edge.requester, group)}};
      std::vector<dsl::Note> notes;
      add_chain(model_, step, notes);
      out->notes.insert(out->notes.begin(), notes.begin(), notes.end());
    }
    if (out) stopped_.insert(group);
    return out;
  }

  /// How each unit in which the requester of this edge requests it is blocked, described for the first one.
  std::optional<Taking> why_units_end(EdgeId edge) {
    std::optional<Taking> out;
    for (const Request& request : shared_.requests().of(model_.edges[edge].target)) {
      if (request.task->edge != edge) continue;
      std::optional<Taking> why = why_unit_ends(model_, facts_, shared_, granted_, request, causer_);
      if (!why) return std::nullopt;
      refused_.push_back(request.task);
      if (!out) out = std::move(why);
    }
    return out;
  }

  std::optional<Taking> why_requester_stopped(GroupId requester) {
    // The task does not stop what leads to it, or what goes before it.
    if (shared_.claims(requester).contains(granted_.task)) return std::nullopt;
    if (!granted_.takings.may_beat(requester)) return std::nullopt;
    return why_stopped(requester);
  }

  bool may_request(GroupId from, GroupId to) const {
    const std::vector<Branch>& branches = shared_.branches().from(from);
    return facts_.requested.contains(from) && std::any_of(branches.begin(), branches.end(), [&](const Branch& branch) {
             return branch.to == to && !branch.by_need;
           });
  }

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const Granted& granted_;
  ProviderId causer_;
  std::set<GroupId> seen_;    ///< groups whose requesters were looked at
  std::set<GroupId> stopped_; ///< of these, the ones that are known to stop
  std::vector<const Task*> refused_;
};

/// Whether its unit lacks another member.
bool is_refused(const Model& model, const Granted& granted, const Request& request) {
  if (request.pack->name.empty() || !model.is_always_member(*request.task)) return false;
  const std::vector<const Task*> unit = unit_members(model, *request.pack);
  return std::any_of(unit.begin(), unit.end(),
                     [&](const Task* member) { return granted.takings.takes(member->target); });
}

bool stays_requested(const Input& input, const Granted& granted, GroupId group, std::set<GroupId>& seen) {
  if (!seen.insert(group).second) return false;
  const std::vector<Request>& requests = input.shared.requests().of(group);
  return std::any_of(requests.begin(), requests.end(), [&](const Request& request) {
    if (!request.requester) return true;
    const GroupId above = input.model.providers[*request.requester].group;
    if (leads_to_granted(input.shared, above, granted) || !granted.takings.may_beat(above)) return true;
    const std::vector<ProviderId>& all = input.model.groups[above].providers;
    const bool goes_on = std::any_of(all.begin(), all.end(), [&](ProviderId id) {
      return input.facts.active.contains(id) && granted.takings.need_taken(id) == nullptr;
    });
    return goes_on && !granted.takings.takes(above) && !is_refused(input.model, granted, request) &&
           stays_requested(input, granted, above, seen);
  });
}

} // namespace

std::optional<StopReason> why_stopped(const Input& input, const Granted& granted, GroupId group, ProviderId causer) {
  StoppedSearch search(input, granted, causer);
  std::optional<Taking> how = search.why_stopped(group);
  if (!how) return std::nullopt;
  return StopReason{std::move(*how), search.refused().size() == 1 ? search.refused().front() : nullptr};
}

bool stays_requested(const Input& input, const Granted& granted, GroupId group) {
  std::set<GroupId> seen;
  return stays_requested(input, granted, group, seen);
}

} // namespace director::analysis
