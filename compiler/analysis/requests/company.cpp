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
  if (is_wanted(requester) || !visited_.insert(requester).second) return {};
  for (const Request& above : requests_.of(requester)) {
    const std::vector<const Task*> chain = find_bare_chain(above, false);
    if (chain.empty()) continue;
    out.insert(out.end(), chain.begin(), chain.end());
    return out;
  }
  return {};
}

std::optional<Company::Rank> Company::find_outranking(const Request& request) {
  visited_.clear(); // paths up that were followed for another request
  return find_outranking(request, true);
}

std::optional<Company::Rank> Company::find_outranking(const Request& request, bool waits) {
  if (!request.requester) return std::nullopt;
  const std::vector<Task>& entries = request.pack->tasks;
  for (const Use<GroupId>& need : model_.providers[*request.requester].needs) {
    if (wanted_.size() == 1 && need.id == wanted_.front())
      return Rank{&entries, request.task, nullptr, &need, request.requester};
  }
  const Task* first = nullptr;
  for (const Task& entry : entries) {
    if (request.pack->name.empty() || entry.target == request.task->target || !brings(entry)) continue;
    const bool together = waits && model_.is_usually_member(*request.task) && model_.is_usually_member(entry);
    if (together || !brings_firmly(entry) || !goes_first(model_, entry, *request.task)) return std::nullopt;
    if (first == nullptr) first = &entry;
  }
  if (first != nullptr) return Rank{&entries, request.task, first, nullptr, std::nullopt};
  const GroupId requester = model_.providers[*request.requester].group;
  if (!visited_.insert(requester).second) return std::nullopt;
  for (const Request& above : requests_.of(requester)) {
    if (const std::optional<Rank> found = find_outranking(above, false)) return found;
  }
  return std::nullopt;
}

bool Company::goes_first(const Model& model, const Task& a, const Task& b) {
  return std::all_of(a.levels.begin(), a.levels.end(), [&](const Task::NamedLevel& one) {
    const Level& high = model.edges[a.edge].levels[one.level];
    return std::all_of(b.levels.begin(), b.levels.end(), [&](const Task::NamedLevel& other) {
      const Level& low = model.edges[b.edge].levels[other.level];
      return high.optional == low.optional ? high.priority >= low.priority : low.optional;
    });
  });
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

bool Company::is_wanted(GroupId group) const {
  return std::find(wanted_.begin(), wanted_.end(), group) != wanted_.end();
}

bool Company::is_covered(const Request& request, bool waits) {
  if (request.requester && request.pack->name.empty()) return false;
  const std::vector<Task>& entries = request.requester ? request.pack->tasks : model_.roots;
  // Members of one unit are granted together: none of them requests anything while one waits.
  const bool in_unit = waits && request.requester && model_.is_usually_member(*request.task);
  const bool out = std::any_of(entries.begin(), entries.end(), [&](const Task& entry) {
    if (entry.target == request.task->target) return false;
    // It is not pushed for what is below a root that goes after it.
    if (!request.requester && goes_first(model_, entry, *request.task) && !goes_first(model_, *request.task, entry))
      return false;
    if (!in_unit || is_wanted(entry.target) || !model_.is_usually_member(entry)) return brings(entry);
    if (brings(entry)) held_back_.insert(&entry);
    return false;
  });
  if (out) found_in_.insert(&entries);
  return out;
}

/// Whether the entry is for a wanted group, or a mandatory one for a group that always requests one.
bool Company::brings(const Task& entry) {
  if (is_wanted(entry.target)) return true;
  if (!leading_.contains(entry.target)) return false;
  const bool mandatory = !model_.edges[entry.edge].levels[entry.levels.front().level].optional;
  return mandatory && always_requests(entry.target);
}

/// The same if nothing on some path is optional.
bool Company::brings_firmly(const Task& entry) {
  const auto is_optional = [&](const Task::NamedLevel& level) {
    return model_.edges[entry.edge].levels[level.level].optional;
  };
  if (std::any_of(entry.levels.begin(), entry.levels.end(), is_optional)) return false;
  if (is_wanted(entry.target)) return true;
  const auto [at, is_new] = firm_.try_emplace(entry.target, false);
  if (!is_new) return at->second;
  bool out = true;
  for (const ProviderId id : model_.groups[entry.target].providers) {
    if (!facts_.active.contains(id)) continue;
    const std::vector<Pack>& packs = model_.providers[id].packs;
    const auto leads_firmly = [&](const Task& task) { return brings(task) && brings_firmly(task); };
    out = out && !packs.empty() && std::all_of(packs.begin(), packs.end(), [&](const Pack& pack) {
            return std::any_of(pack.tasks.begin(), pack.tasks.end(), leads_firmly);
          });
  }
  return firm_[entry.target] = out;
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

bool need_not_be_requested(const Model& model, const Facts& facts, const Requests& requests, const Request& request,
                           const std::vector<GroupId>& groups) {
  const bool has_root = std::any_of(model.roots.begin(), model.roots.end(), [&](const Task& root) {
    return std::find(groups.begin(), groups.end(), root.target) != groups.end();
  });
  return request.requester && !has_root && !Company(model, facts, requests, groups).find_bare_chain(request).empty();
}

} // namespace director::analysis
