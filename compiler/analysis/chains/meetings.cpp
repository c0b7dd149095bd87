// Header: compiler/analysis/chains/meetings.hpp. Test: tests/compiler/analysis/chains/meetings_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/chains/meetings.hpp"

#include "compiler/graph/graph.hpp"

#include <algorithm>
#include <tuple>

namespace director::analysis {

std::vector<Together> find_together(const Model& model, const std::function<bool(ProviderId)>& counts) {
  std::vector<Together> out;
  if (!model.roots.empty()) out.push_back({std::nullopt, &model.roots, {}, false});
  for (const ProviderId id : model.providers.ids()) {
    if (!counts(id)) continue;
    const Provider& provider = model.providers[id];
    for (const Pack& pack : provider.packs) out.push_back({id, &pack.tasks, pack.name, provider.has_packs});
  }
  return out;
}

Chains::Chains(const Model& model, std::function<bool(ProviderId)> counts)
    : model_(model),
      counts_(std::move(counts)),
      together_(find_together(model, counts_)),
      entries_(model.groups.size()) {
  for (const Together& together : together_) {
    for (const Task& task : *together.tasks) entries_[task.target.value].emplace_back(&together, &task);
  }
}

std::vector<Chains::Above> Chains::above(GroupId waiter, End end) const {
  std::vector<Above> out{{waiter, false, false}};
  SparseSet<GroupId> seen[4];
  seen[0].add(waiter);
  for (std::size_t next = 0; next < out.size(); ++next) {
    const Above here = out[next];
    const auto reach = [&](GroupId group, bool optional, bool direct) {
      if (seen[(optional ? 1 : 0) + (direct ? 2 : 0)].add(group)) out.push_back({group, optional, direct});
    };
    const bool is_first = next == 0;
    for (const auto& [together, task] : entries_[here.group.value]) {
      if (!together->provider) continue;
      const GroupId requester = model_.providers[*together->provider].group;
      const Edge& edge = model_.edges[task->edge];
      const bool direct = is_first && end == End::pushing;
      if (edge.has_mandatory()) reach(requester, here.optional, direct);
      if (edge.has_optional()) reach(requester, true, direct);
    }
    if (is_first && end != End::held) continue; // a waiting task was requested, not only needed
    if (here.direct) continue;
    // Chains also lead through a needed group: it may still run for an older request.
    for (const EdgeId id : model_.groups[here.group].requesters) {
      if (model_.edges[id].needed) reach(*model_.edges[id].requester, here.optional, false);
    }
  }
  return out;
}

const std::vector<Chains::Entry>& Chains::entries_above(GroupId group, End end) const {
  const auto [at, is_new] = entries_above_[static_cast<std::size_t>(end)].try_emplace(group);
  std::vector<Entry>& out = at->second;
  if (!is_new) return out;
  for (const Above& here : above(group, end)) {
    for (const auto& [together, task] : entries_[here.group.value]) {
      if (together->tasks->size() > 1) out.push_back({together, task, !here.optional, here.optional});
    }
  }
  std::sort(out.begin(), out.end(),
            [](const Entry& a, const Entry& b) { return std::tie(a.together, a.task) < std::tie(b.together, b.task); });
  const auto merge = [&](Entry& kept, const Entry& next) {
    if (kept.together != next.together || kept.task != next.task) return false;
    kept.mandatory = kept.mandatory || next.mandatory;
    kept.optional = kept.optional || next.optional;
    return true;
  };
  std::size_t count = 0;
  for (const Entry& entry : out) {
    if (count == 0 || !merge(out[count - 1], entry)) out[count++] = entry;
  }
  out.resize(count);
  return out;
}

/// Visits the pair at one level of each entry.
void Chains::visit_pair(Meeting& meeting, bool optional_above, const Entry& second, GroupId other,
                        const std::function<void(const Meeting&, GroupId other)>& visitor) const {
  meeting.first_optional = optional_above || meeting.first_level.optional;
  if (second.mandatory) {
    meeting.second_optional = meeting.second_level.optional;
    visitor(meeting, other);
  }
  if (second.optional) {
    meeting.second_optional = true;
    visitor(meeting, other);
  }
}

std::vector<std::pair<const Chains::Entry*, GroupId>>
Chains::siblings(const Together& together, const Task& task, GroupId waiter, const std::vector<GroupId>& others) const {
  std::vector<std::pair<const Entry*, GroupId>> out;
  for (const GroupId other : others) {
    if (other == waiter) continue;
    const std::vector<Entry>& entries = entries_above(other);
    auto at = std::lower_bound(entries.begin(), entries.end(), &together,
                               [](const Entry& entry, const Together* place) { return entry.together < place; });
    for (; at != entries.end() && at->together == &together; ++at) {
      if (at->task->target != task.target) out.emplace_back(&*at, other);
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.first->task < b.first->task; });
  return out;
}

void Chains::visit(GroupId waiter, const std::vector<GroupId>& others,
                   const std::function<void(const Meeting&, GroupId other)>& visitor) const {
  for (const Above& here : above(waiter, End::requested)) {
    for (const auto& [together, first] : entries_[here.group.value]) {
      for (const auto& [second, other] : siblings(*together, *first, waiter, others)) {
        for (const Task::NamedLevel& a : first->levels) {
          for (const Task::NamedLevel& b : second->task->levels) {
            Meeting meeting{together, first, second->task, model_.edges[first->edge].levels[a.level],
                            model_.edges[second->task->edge].levels[b.level]};
            visit_pair(meeting, here.optional, *second, other, visitor);
          }
        }
      }
    }
  }
}

bool Chains::beats(const Entry& waiting, const Entry& entry, GroupId other, bool by_optional) const {
  // What each provider of the requester needs is claimed with it; another one may keep the requests of this one.
  const std::optional<ProviderId> requester = waiting.together->provider;
  if (requester) {
    const std::vector<ProviderId>& all = model_.group_of(*requester).providers;
    if (std::all_of(all.begin(), all.end(), [&](ProviderId id) {
          return (id != *requester && !counts_(id)) || model_.providers[id].needs_group(other);
        }))
      return false;
  }
  for (const Task::NamedLevel& a : waiting.task->levels) {
    for (const Task::NamedLevel& b : entry.task->levels) {
      Meeting meeting{waiting.together, waiting.task, entry.task, model_.edges[waiting.task->edge].levels[a.level],
                      model_.edges[entry.task->edge].levels[b.level]};
      if (other == entry.task->target && meeting.one_unit()) continue;
      // Either having no optional edge above it helps only the one, or having one helps only the other.
      meeting.first_optional = by_optional || meeting.first_level.optional || !waiting.mandatory;
      meeting.second_optional = meeting.second_level.optional || entry.optional;
      if (meeting.first_goes_before()) return true;
    }
  }
  return false;
}

bool Chains::may_beat(GroupId waiter, GroupId other, bool by_optional) const {
  if (waiter != other && always_below(waiter, other)) return false; // that is granted by then
  const std::vector<Entry>& ours = entries_above(waiter, End::pushing);
  const std::vector<Entry>& theirs = entries_above(other);
  auto first = theirs.begin();
  for (const Entry& waiting : ours) {
    while (first != theirs.end() && first->together < waiting.together) ++first;
    for (auto at = first; at != theirs.end() && at->together == waiting.together; ++at) {
      if (at->task->target != waiting.task->target && beats(waiting, *at, other, by_optional)) return true;
    }
  }
  return false;
}

bool Chains::always_below(GroupId group, GroupId other) const {
  if (!below_) {
    const Node root = root_node(model_);
    Arrows arrows(root + 1);
    for (const Together& together : together_) {
      std::vector<Node>& row = arrows[together.provider ? model_.providers[*together.provider].group.value : root];
      for (const Task& task : *together.tasks) row.push_back(task.target.value);
    }
    for (const Edge& edge : model_.edges) {
      if (edge.needed) arrows[edge.requester->value].push_back(edge.target.value);
    }
    below_.emplace(arrows, root);
  }
  return below_->is_below(group.value, other.value);
}

} // namespace director::analysis
