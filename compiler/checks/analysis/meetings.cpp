// Door: compiler/checks/analysis/meetings.hpp. Test: tests/checks/analysis/meetings_test.cpp.
#include "compiler/checks/analysis/meetings.hpp"

#include <algorithm>

namespace director::checks {

namespace {

/// A request below which only optional edges lead on.
struct Step {
  GroupId group{};
  bool optional = false;
};

bool has_mandatory(const Edge& edge) {
  return std::any_of(edge.levels.begin(), edge.levels.end(), [](const Level& level) { return !level.optional; });
}
bool has_optional(const Edge& edge) {
  return std::any_of(edge.levels.begin(), edge.levels.end(), [](const Level& level) { return level.optional; });
}

} // namespace

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
      entries_(model.groups.size()),
      below_(model.groups.size()) {
  for (const Together& together : together_) {
    for (const Task& task : *together.tasks) entries_[task.target.value].emplace_back(&together, &task);
  }
}

const Chains::Below& Chains::below(GroupId group) const {
  std::optional<Below>& out = below_[group];
  if (out) return *out;
  const std::size_t count = model_.groups.size();
  out = Below{IdSet<GroupId>(count), IdSet<GroupId>(count)};
  // A needed group leads on as well (it may still run for an older request), but it is not requested by being needed.
  IdSet<GroupId> seen[2] = {IdSet<GroupId>(count), IdSet<GroupId>(count)};
  std::vector<Step> open{{group, false}};
  seen[0].add(group);
  out->mandatory.add(group);
  while (!open.empty()) {
    const Step step = open.back();
    open.pop_back();
    const auto reach = [&](GroupId target, bool optional, bool requested) {
      if (requested) (optional ? out->optional : out->mandatory).add(target);
      if (seen[optional ? 1 : 0].add(target)) open.push_back({target, optional});
    };
    for (const ProviderId id : model_.groups[step.group].providers) {
      if (!counts_(id)) continue;
      const Provider& provider = model_.providers[id];
      for (const Use<GroupId>& need : provider.needs) reach(need.id, step.optional, false);
      for (const Pack& pack : provider.packs) {
        for (const Task& task : pack.tasks) {
          const Edge& edge = model_.edges[task.edge];
          if (has_mandatory(edge)) reach(task.target, step.optional, true);
          if (has_optional(edge)) reach(task.target, true, true);
        }
      }
    }
  }
  return *out;
}

std::vector<Chains::Above> Chains::above(GroupId waiter) const {
  std::vector<Above> out{{waiter, false}};
  IdSet<GroupId> seen[2] = {IdSet<GroupId>(model_.groups.size()), IdSet<GroupId>(model_.groups.size())};
  seen[0].add(waiter);
  for (std::size_t next = 0; next < out.size(); ++next) {
    const Above here = out[next];
    const auto reach = [&](GroupId group, bool optional) {
      if (seen[optional ? 1 : 0].add(group)) out.push_back({group, optional});
    };
    for (const auto& [together, task] : entries_[here.group.value]) {
      if (!together->provider) continue;
      const GroupId requester = model_.providers[*together->provider].group;
      const Edge& edge = model_.edges[task->edge];
      if (has_mandatory(edge)) reach(requester, here.optional);
      if (has_optional(edge)) reach(requester, true);
    }
    if (here.group == waiter) continue; // a task that waits was requested, not only needed
    for (const EdgeId id : model_.groups[here.group].requesters) {
      if (model_.edges[id].needed) reach(*model_.edges[id].requester, here.optional);
    }
  }
  return out;
}

/// At one level of each entry, what lies below the second one's.
void Chains::visit_pair(Meeting& meeting, bool optional_above, const std::vector<GroupId>& others,
                        const std::function<void(const Meeting&, GroupId other)>& visitor) const {
  const Below& reached = below(meeting.second->target);
  meeting.first_optional = optional_above || meeting.first_level.optional;
  for (const GroupId other : others) {
    if (reached.mandatory.contains(other)) {
      meeting.second_optional = meeting.second_level.optional;
      visitor(meeting, other);
    }
    if (reached.optional.contains(other)) {
      meeting.second_optional = true;
      visitor(meeting, other);
    }
  }
}

void Chains::visit(GroupId waiter, const std::vector<GroupId>& others,
                   const std::function<void(const Meeting&, GroupId other)>& visitor) const {
  std::vector<GroupId> but_the_waiter = others;
  but_the_waiter.erase(std::remove(but_the_waiter.begin(), but_the_waiter.end(), waiter), but_the_waiter.end());
  for (const Above& here : above(waiter)) {
    for (const auto& [together, first] : entries_[here.group.value]) {
      for (const Task& second : *together->tasks) {
        if (second.target == first->target) continue;
        for (const Task::NamedLevel& a : first->levels) {
          for (const Task::NamedLevel& b : second.levels) {
            Meeting meeting{together, first, &second, model_.edges[first->edge].levels[a.level],
                            model_.edges[second.edge].levels[b.level]};
            visit_pair(meeting, here.optional, but_the_waiter, visitor);
          }
        }
      }
    }
  }
}

IdSet<GroupId> Chains::beaten_by(GroupId waiter, const std::vector<GroupId>& others) const {
  IdSet<GroupId> out(model_.groups.size());
  visit(waiter, others, [&](const Meeting& meeting, GroupId other) {
    if (other == meeting.second->target && meeting.one_unit()) return;
    if (meeting.first_goes_before()) out.add(other);
  });
  return out;
}

} // namespace director::checks
