// Header: compiler/analysis/rounds/own_promises.hpp. Test: compiler/checks/undone_by_itself.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/rounds/own_promises.hpp"

#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/requests/gaps.hpp"
#include "compiler/analysis/shared/shared.hpp"

#include <algorithm>
#include <vector>

namespace director::analysis {

OwnPromises::OwnPromises(const Input& input)
    : model_(input.model),
      facts_(input.facts),
      shared_(input.shared),
      earlier_(model_, facts_, shared_.requests(), shared_.rivals(), shared_.budget()) {}

bool OwnPromises::may_end(GroupId task, const Want& want, const ConditionUse& promise) const {
  const Condition& set = model_.conditions[promise.id];
  if (set.state != model_.conditions[want.condition.id].state) return false;
  const ValueSet values = undoing_values(model_, want.waiter, want.condition.id, set.accepts);
  if (values.empty()) return false;
  const auto lasts = [&](const Request& request) {
    if (!request.requester || !ends_unpushed(task, want, *request.task)) return false;
    const std::vector<Region> regions = shared_.requests().regions(request);
    return std::any_of(regions.begin(), regions.end(), [&](const Region& region) {
      Box box = box_of(facts_.values, region);
      Possible& here = possible_in(model_, facts_, set.state, box);
      here = {here.values.intersected(values), false};
      return !here.empty() && earlier_.may_exist(request, box);
    });
  };
  const std::vector<Request>& requests = shared_.requests().of(task);
  return std::any_of(requests.begin(), requests.end(), lasts);
}

/// Whether at this request nothing pushes the provider, and it pushes one of those that cause its condition.
bool OwnPromises::ends_unpushed(GroupId task, const Want& want, const Task& request) const {
  const bool pushes = std::any_of(want.causers.begin(), want.causers.end(), [&](ProviderId id) {
    return goes_before_at(task, model_.providers[id].group, request, &Meeting::first);
  });
  if (!pushes || !facts_.pushed.contains(want.waiter)) return pushes;
  if (!pushers_) pushers_ = find_pushers();
  const auto known = pushers_->find(want.waiter);
  return known != pushers_->end() && std::none_of(known->second.begin(), known->second.end(), [&](GroupId pusher) {
           return goes_before_at(pusher, task, request, &Meeting::second);
         });
}

/// Whether the one goes before the other where this request of one of them, or what leads to it, meets the other.
bool OwnPromises::goes_before_at(GroupId first, GroupId second, const Task& request, const Task* Meeting::*side) const {
  bool out = false;
  shared_.chains().visit(first, {second}, [&](const Meeting& meeting, GroupId) {
    const Task* entry = meeting.*side;
    out = out || (!meeting.one_unit() && meeting.first_goes_before() &&
                  (entry == &request || entry->target != request.target));
  });
  return out;
}

/// The tasks that may push a provider, for what they wait for themselves or for another push.
std::map<ProviderId, std::set<GroupId>> OwnPromises::find_pushers() const {
  std::map<ProviderId, std::set<GroupId>> out;
  for (const std::vector<Wanting>* all : {&shared_.wants(), &shared_.wants_of_pushed()}) {
    for (const Wanting& wanting : *all) {
      for (const Want& want : wanting.wants) {
        for (const ProviderId id : want.causers) out[id].insert(want.pushed ? want.pushed->by : wanting.task);
      }
    }
  }
  return out;
}

} // namespace director::analysis
