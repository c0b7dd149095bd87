// Header: compiler/checks/check.hpp. Test: compiler/checks/hard_hand_over.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/contenders.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/choice.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace director::checks {

namespace {

/// An entry of one of the requester's packs.
struct Course {
  ProviderId provider{};
  const Pack* pack = nullptr;
  const Task* task = nullptr;
};

/// Why a planner may stop requesting a skill while it runs.
struct Gap {
  const Pack* pack = nullptr; ///< one that does not lead to the skill, of this provider
  ProviderId provider{};
  std::optional<ConditionUse> waits_for; ///< or the condition that the planner may have to wait for
};

class HandOvers {
public:
  HandOvers(const Input& input, Findings& findings) : input_(input), findings_(findings) {}

  void look_at(const Group& group) {
    const std::vector<Course> courses = find_courses(group);
    std::map<GroupId, std::vector<const Course*>> by_skill;
    for (const Course& course : courses) {
      for (const GroupId skill : skills_below(course.task->target)) by_skill[skill].push_back(&course);
    }
    for (const auto& [skill, users] : by_skill) {
      for (const Course* next : users) {
        const auto previous = std::find_if(users.begin(), users.end(), [&](const Course* other) {
          return other->task->target != next->task->target && !has(*other->pack, next->task->target) &&
                 !leads_to(*next->pack, other->task->target) && !is_led_to_otherwise(*next, skill);
        });
        if (previous == users.end() || !seen_.insert({next->task->target, skill}).second) continue;
        if (const auto gap = find_gap(next->provider, next->task->target, skill))
          report(**previous, *next, skill, *gap);
      }
      look_at_skill(courses, skill, users);
    }
  }

private:
  std::vector<Course> find_courses(const Group& group) const {
    std::vector<Course> out;
    for (const ProviderId id : group.providers) {
      const Provider& provider = input_.model.providers[id];
      if (!provider.has_packs || !input_.facts.active.contains(id)) continue;
      for (const Pack& pack : provider.packs) {
        for (const Task& task : pack.tasks) out.push_back({id, &pack, &task});
      }
    }
    return out;
  }

  /// Where the requester requests the skill itself, beside a planner that goes before it.
  void look_at_skill(const std::vector<Course>& courses, GroupId skill, const std::vector<const Course*>& users) {
    for (const Course& next : courses) {
      if (next.task->target != skill || is_led_to_otherwise(next, skill)) continue;
      const auto deferring = find_deferring(input_, *next.pack, *next.task, skill);
      if (!deferring) continue;
      const auto previous = std::find_if(users.begin(), users.end(), [&](const Course* other) {
        return !has(*other->pack, skill) && !leads_to(*next.pack, other->task->target);
      });
      if (previous == users.end() || !seen_.insert({deferring->planner->target, skill}).second) continue;
      report(**previous, next, *deferring);
    }
  }

  /// The skills that the task's group requests, the nearest on each path: those below follow them.
  const std::vector<GroupId>& skills_below(GroupId task) {
    const auto [at, is_new] = skills_.try_emplace(task);
    if (!is_new) return at->second;
    std::set<GroupId> seen{task};
    std::vector<GroupId> open{task};
    for (std::size_t next = 0; next < open.size(); ++next) {
      for (const Branch& branch : input_.shared.branches().from(open[next])) {
        if (branch.by_need || !seen.insert(branch.to).second) continue;
        (stop_matters(input_.model, branch.to) ? at->second : open).push_back(branch.to);
      }
    }
    return at->second;
  }

  static bool has(const Pack& pack, GroupId target) {
    return std::any_of(pack.tasks.begin(), pack.tasks.end(), [&](const Task& task) { return task.target == target; });
  }

  bool leads_to(GroupId from, GroupId to) const { return input_.shared.claims(from).contains(to); }

  bool leads_to(const Pack& pack, GroupId to) const {
    return std::any_of(pack.tasks.begin(), pack.tasks.end(),
                       [&](const Task& task) { return leads_to(task.target, to); });
  }

  /// Whether another task of the same pack requests the skill too, and may keep it running.
  bool is_led_to_otherwise(const Course& course, GroupId skill) const {
    return std::any_of(course.pack->tasks.begin(), course.pack->tasks.end(), [&](const Task& task) {
      return task.target != course.task->target && leads_to(task.target, skill);
    });
  }

  std::optional<Gap> find_gap(ProviderId requester, GroupId planner, GroupId skill) const {
    const Model& model = input_.model;
    const Region region = active_region(model, model.providers[requester]);
    std::vector<Region> providers;
    std::optional<ConditionUse> condition;
    for (const ProviderId id : model.groups[planner].providers) {
      providers.push_back(region_of(model, model.providers[id].when));
      if (!model.providers[id].when.empty() && !condition) condition = model.providers[id].when.front();
    }
    if (condition &&
        find_covering(model, region, providers, input_.facts.values, input_.shared.budget()) == Covering::open)
      return Gap{nullptr, {}, condition};
    for (const ProviderId id : model.groups[planner].providers) {
      const Provider& provider = model.providers[id];
      if (!input_.facts.active.contains(id) || !compatible(active_region(model, provider), region)) continue;
      for (const Pack& pack : provider.packs) {
        if (provider.has_packs && !leads_to(pack, skill)) return Gap{&pack, id, std::nullopt};
      }
    }
    return std::nullopt;
  }

  void report(const Course& previous, const Course& next, GroupId skill, const Gap& gap) {
    const Model& model = input_.model;
    const std::string name = name_of(model, skill), planner = name_of(model, next.task->target);
    dsl::Diagnostic& finding =
        findings_.add(next.task->span, fmt::format("from {} to {} {} may be stopped and started again",
                                                   name_of(model, previous.task->target), planner, name));
    finding.notes.push_back(
        {previous.task->span, fmt::format("{} is requested here", name_of(model, previous.task->target))});
    add_path(previous.task->target, skill, finding);
    add_path(next.task->target, skill, finding);
    if (gap.waits_for) {
      finding.notes.push_back(
          {gap.waits_for->span, fmt::format("{} may have to wait for {}, and meanwhile nothing requests {}", planner,
                                            name_of(model, gap.waits_for->id), name)});
    } else {
      finding.notes.push_back({gap.pack->span, fmt::format("{} may choose `{}`, which does not lead to {}",
                                                           name_of(model, gap.provider), gap.pack->name, name)});
    }
    finding.help = fmt::format(
        "request something that rests in {}, `apart` beside {}, so that it can be pushed to rest", name, planner);
  }

  void report(const Course& previous, const Course& next, const Deferring& deferring) {
    const Model& model = input_.model;
    const GroupId skill = next.task->target, before = deferring.planner->target;
    const std::string name = name_of(model, skill), planner = name_of(model, before);
    dsl::Diagnostic& finding =
        findings_.add(next.task->span, fmt::format("from {} to {} {} may be stopped and started again",
                                                   name_of(model, previous.task->target), planner, name));
    finding.notes.push_back(
        {previous.task->span, fmt::format("{} is requested here", name_of(model, previous.task->target))});
    add_path(previous.task->target, skill, finding);
    finding.notes.push_back(
        {deferring.planner->span,
         fmt::format("{} goes before {}, and may request {}: until it has decided, {} is not granted "
                     "here",
                     planner, name, name_of(model, deferring.group), name)});
    add_path(before, deferring.group, finding);
    finding.help = fmt::format(
        "instead of {0}, request a group that requests {0}, and does not need it, `apart` beside {1}", name, planner);
  }

  void add_path(GroupId from, GroupId skill, dsl::Diagnostic& finding) const {
    add_chain(input_.model, input_.shared.claims(from).path(skill), finding.notes);
  }

  const Input& input_;
  Findings& findings_;
  std::map<GroupId, std::vector<GroupId>> skills_;
  std::set<std::pair<GroupId, GroupId>> seen_; ///< planner and skill
};

} // namespace

void hard_hand_over(const Input& input, Findings& findings) {
  for (const Group& group : input.model.groups) HandOvers(input, findings).look_at(group);
}

} // namespace director::checks
