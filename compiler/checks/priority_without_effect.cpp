// Header: compiler/checks/check.hpp. Test: compiler/checks/priority_without_effect.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/pushes.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

namespace director::checks {

namespace {

/// The groups for which the rank of a task matters: every group that it may come to hold, and every group that may be
/// pushed for it or for one of these.
class Stakes {
public:
  explicit Stakes(const Input& input) : input_(input), causers_(find_causers(input.model)) {}

  const std::vector<GroupId>& of(GroupId task) {
    const auto [at, is_new] = stakes_.try_emplace(task);
    if (!is_new) return at->second;
    std::vector<GroupId> out = input_.shared.claims(task).groups();
    SparseSet<GroupId> seen;
    for (const GroupId group : out) seen.add(group);
    for (std::size_t next = 0; next < out.size(); ++next) {
      for (const GroupId pushed : pushed_by(out[next])) {
        if (seen.add(pushed)) out.push_back(pushed);
      }
    }
    return stakes_[task] = std::move(out);
  }

private:
  /// Groups whose providers cause what the group waits for, and what these take.
  const std::vector<GroupId>& pushed_by(GroupId group) {
    const auto [at, is_new] = pushed_by_.try_emplace(group);
    if (!is_new) return at->second;
    for (const ProviderId id : input_.model.groups[group].providers) {
      for (const ConditionUse& use : input_.model.providers[id].when) {
        for (const ProviderId causer : causers_[use.id]) at->second.push_back(input_.model.providers[causer].group);
      }
    }
    return at->second;
  }

  const Input& input_;
  Causers causers_;
  std::unordered_map<GroupId, std::vector<GroupId>> stakes_, pushed_by_;
};

bool has_priority(const Model& model, const Task& task) {
  const std::vector<Level>& levels = model.edges[task.edge].levels;
  return std::any_of(task.levels.begin(), task.levels.end(),
                     [&](const Task::NamedLevel& named) { return levels[named.level].priority != 0; });
}

std::string beside(const Model& model, const Together& together) {
  if (!together.provider) return "no other root";
  if (together.pack.empty()) return fmt::format("no other task of {}", name_of(model, *together.provider));
  return fmt::format("no other task of the pack `{}`", together.pack);
}

void look_at(const Input& input, const Together& together, Stakes& stakes, Findings& findings) {
  const Model& model = input.model;
  const std::vector<Task>& tasks = *together.tasks;
  if (std::none_of(tasks.begin(), tasks.end(), [&](const Task& task) { return has_priority(model, task); })) return;
  std::unordered_map<GroupId, std::size_t> wanted_by;
  for (const Task& task : tasks) {
    for (const GroupId group : stakes.of(task.target)) ++wanted_by[group];
  }
  for (const Task& task : tasks) {
    const std::vector<GroupId>& own = stakes.of(task.target);
    if (!has_priority(model, task) ||
        std::any_of(own.begin(), own.end(), [&](GroupId group) { return wanted_by[group] > 1; }))
      continue;
    findings
        .add(task.span, fmt::format("the priority of {} decides nothing: {} may ever want the same group",
                                    name_of(model, task.target), beside(model, together)))
        .help = "remove it, so that the priorities that are written are those that count";
  }
}

} // namespace

void priority_without_effect(const Input& input, Findings& findings) {
  Stakes stakes(input);
  for (const Together& together : input.shared.chains().together()) look_at(input, together, stakes, findings);
}

} // namespace director::checks
