// Header: compiler/analysis/chains/overlaps.hpp. Test: tests/compiler/analysis/chains/overlaps_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/chains/overlaps.hpp"

#include <map>

namespace director::analysis {

Overlaps::Overlaps(const Model& model, const Branches& branches)
    : model_(model),
      branches_(branches),
      lonely_(model.groups.size()),
      found_by_(model.groups.size(), no_group) {
  // From the leaves up: a group on a cycle always has an edge left.
  IdTable<GroupId, std::size_t> left(model.groups.size()); // edges to groups below which two entries may still meet
  for (const Edge& edge : model.edges) {
    if (edge.requester) ++left[*edge.requester];
  }
  std::vector<GroupId> open;
  const auto look_at = [&](GroupId group) {
    if (left[group] == 0 && model.groups[group].requesters.size() < 2 && lonely_.add(group)) open.push_back(group);
  };
  for (const GroupId group : model.groups.ids()) look_at(group);
  while (!open.empty()) {
    const GroupId group = open.back();
    open.pop_back();
    for (const EdgeId id : model.groups[group].requesters) {
      const Edge& edge = model.edges[id];
      if (!edge.requester) continue;
      --left[*edge.requester];
      look_at(*edge.requester);
    }
  }
}

// An entry stops at groups that an earlier entry has visited, as that one has continued from there. This loses no
// overlap: if two entries reach one group, the later one meets on its path either the earlier one, or a third one that
// came between the two and has met the earlier one for the same reason.
std::vector<bool> Overlaps::among(const std::vector<GroupId>& targets) {
  std::vector<bool> out(targets.size(), false);
  std::vector<GroupId> found, open;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    open.push_back(targets[i]);
    while (!open.empty()) {
      const GroupId group = open.back();
      open.pop_back();
      std::size_t& by = found_by_[group];
      if (by == i) continue;
      if (by != no_group) {
        out[i] = out[by] = true;
        continue;
      }
      by = i;
      found.push_back(group);
      if (lonely_.contains(group)) continue;
      for (const Branch& branch : branches_.from(group)) open.push_back(branch.to);
    }
  }
  for (const GroupId group : found) found_by_[group] = no_group;
  return out;
}

std::vector<std::vector<std::int32_t>> Overlaps::among(const std::vector<Task>& entries,
                                                       const std::vector<std::set<std::int32_t>>& priorities) {
  std::map<std::int32_t, std::vector<std::size_t>> by_priority;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    for (const std::int32_t priority : priorities[i]) by_priority[priority].push_back(i);
  }
  std::vector<std::vector<std::int32_t>> out(entries.size());
  for (const auto& [priority, like] : by_priority) {
    if (like.size() < 2) continue;
    std::vector<GroupId> targets;
    for (const std::size_t entry : like) targets.push_back(entries[entry].target);
    const std::vector<bool> overlap = among(targets);
    for (std::size_t at = 0; at < like.size(); ++at) {
      if (overlap[at]) out[like[at]].push_back(priority);
    }
  }
  return out;
}

} // namespace director::analysis
