// Header: compiler/analysis/requests/company.hpp. Test: compiler/checks/causer_not_running.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/requests/company.hpp"

#include <algorithm>

namespace director::analysis {

std::vector<const Task*> Company::find_bare_chain(const Request& request) { return find_bare_chain(request, true); }

std::vector<const Task*> Company::find_bare_chain(const Request& request, bool waits) {
  if (is_covered(request, waits)) return {};
  std::vector<const Task*> out{request.task};
  if (!request.requester) return out;
  const GroupId requester = model_.providers[*request.requester].group;
  if (!visited_.insert(requester).second) return {};
  for (const Request& above : requests_.of(requester)) {
    const std::vector<const Task*> chain = find_bare_chain(above, false);
    if (chain.empty()) continue;
    out.insert(out.end(), chain.begin(), chain.end());
    return out;
  }
  return {};
}

void Company::find_leading() {
  std::vector<GroupId> open = wanted_;
  while (!open.empty()) {
    const GroupId group = open.back();
    open.pop_back();
    for (const Request& request : requests_.of(group)) {
      if (!request.requester) continue;
      const GroupId requester = model_.providers[*request.requester].group;
      if (leading_.add(requester)) open.push_back(requester);
    }
  }
}

bool Company::is_member(const Task& entry) const {
  return model_.edges[entry.edge].levels[entry.levels.front().level].shares_unit();
}

bool Company::is_wanted(GroupId group) const {
  return std::find(wanted_.begin(), wanted_.end(), group) != wanted_.end();
}

bool Company::is_covered(const Request& request, bool waits) {
  if (request.requester && request.pack->name.empty()) return false;
  const std::vector<Task>& entries = request.requester ? request.pack->tasks : model_.roots;
  // Members of one unit are granted together: none of them requests anything while one waits.
  const bool in_unit = waits && request.requester && is_member(*request.task);
  const bool out = std::any_of(entries.begin(), entries.end(), [&](const Task& entry) {
    if (entry.target == request.task->target) return false;
    if (!in_unit || is_wanted(entry.target) || !is_member(entry)) return brings(entry);
    if (brings(entry)) held_back_.insert(&entry);
    return false;
  });
  if (out) found_in_.insert(&entries);
  return out;
}

/// The entry is for a wanted group, or a mandatory one for a group that always requests one.
bool Company::brings(const Task& entry) {
  if (is_wanted(entry.target)) return true;
  if (!leading_.contains(entry.target)) return false;
  const bool mandatory = !model_.edges[entry.edge].levels[entry.levels.front().level].optional;
  return mandatory && always_requests(entry.target);
}

bool Company::always_requests(GroupId group) {
  const auto [at, is_new] = always_.try_emplace(group, false);
  if (!is_new) return at->second;
  bool out = true;
  for (const ProviderId id : model_.groups[group].providers) {
    if (!facts_.active.contains(id)) continue;
    const std::vector<Pack>& packs = model_.providers[id].packs;
    const auto brings_one = [&](const Pack& pack) {
      return std::any_of(pack.tasks.begin(), pack.tasks.end(), [&](const Task& task) { return brings(task); });
    };
    out = out && !packs.empty() && std::all_of(packs.begin(), packs.end(), brings_one);
  }
  return always_[group] = out;
}

} // namespace director::analysis
