// Header: compiler/checks/check.hpp. Test: compiler/checks/priority_without_effect.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/pushes.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"
#include "compiler/model/closure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_map>

namespace director::checks {

namespace {

/// Every group that the task may come to hold; and what it, and these, may wait for: also needs that it can never have.
std::vector<GroupId> groups_of(const Input& input, GroupId task) {
  std::vector<GroupId> out = input.shared.claims(task).groups();
  out.push_back(task);
  add_needed(input.model, out);
  return out;
}

/// The groups for which the rank of a task matters: its own, and every group that may be pushed for one of these.
class AffectedGroups {
public:
  explicit AffectedGroups(const Input& input) : input_(input), causers_(find_causers(input.model)) {}

  const std::vector<GroupId>& of(GroupId task) {
    const auto [at, is_new] = affected_.try_emplace(task);
    if (!is_new) return at->second;
    std::vector<GroupId> out = groups_of(input_, task);
    SparseSet<GroupId> seen;
    for (const GroupId group : out) seen.add(group);
    for (std::size_t next = 0; next < out.size(); ++next) {
      for (const GroupId pushed : pushed_by(out[next])) {
        if (seen.add(pushed)) out.push_back(pushed);
      }
    }
    return affected_[task] = std::move(out);
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
  std::unordered_map<GroupId, std::vector<GroupId>> affected_, pushed_by_;
};

/// The states that bodies and handlers set for a task, and those on which its conditions and those below it depend.
struct Touched {
  std::vector<StateId> set, read; ///< each once
};

class TouchedStates {
public:
  explicit TouchedStates(const Input& input) : input_(input), of_group_(input.model.groups.size()) {
    const Model& model = input.model;
    const auto add = [](std::vector<StateId>& to, StateId state) {
      if (std::find(to.begin(), to.end(), state) == to.end()) to.push_back(state);
    };
    for (const StateId state : model.states.ids()) {
      if (model.states[state].of) add(of_group_[model.states[state].of->id].set, state);
    }
    for (const auto& sources : find_sources(model)) {
      for (const Source& source : sources) {
        if (source.provider) add(of_group_[model.providers[*source.provider].group].set, source.state);
        if (source.group) add(of_group_[*source.group].set, source.state);
      }
    }
    for (const Provider& provider : model.providers) {
      for (const auto* uses : {&provider.when, &provider.stay}) {
        for (const ConditionUse& use : *uses) add(of_group_[provider.group].read, model.conditions[use.id].state);
      }
    }
  }

  const Touched& of(GroupId task) {
    const auto [at, is_new] = of_task_.try_emplace(task);
    Touched& out = at->second;
    if (!is_new) return out;
    SparseSet<StateId> set, read;
    for (const GroupId group : groups_of(input_, task)) {
      for (const StateId state : of_group_[group].set) {
        if (set.add(state)) out.set.push_back(state);
      }
      for (const StateId state : of_group_[group].read) {
        if (read.add(state)) out.read.push_back(state);
      }
    }
    return out;
  }

private:
  const Input& input_;
  IdTable<GroupId, Touched> of_group_;
  std::unordered_map<GroupId, Touched> of_task_;
};

/// Whether it matters which of these tasks has its bodies run first: one sets a state that another sets, or depends on.
class SharedStates {
public:
  SharedStates(TouchedStates& states, const std::vector<Task>& tasks) {
    for (const Task& task : tasks) {
      const Touched& touched = states.of(task.target);
      for (const StateId state : touched.set) ++set_by_[state];
      for (const StateId state : touched.read) ++read_by_[state];
    }
  }

  bool matter_for(const Touched& touched) const {
    const auto count = [](const std::unordered_map<StateId, std::size_t>& by, StateId state) {
      const auto at = by.find(state);
      return at == by.end() ? std::size_t{0} : at->second;
    };
    const auto is_in = [](const std::vector<StateId>& all, StateId state) {
      return std::find(all.begin(), all.end(), state) != all.end();
    };
    const bool by_setting = std::any_of(touched.set.begin(), touched.set.end(), [&](StateId state) {
      return count(set_by_, state) > 1 || count(read_by_, state) > (is_in(touched.read, state) ? 1U : 0U);
    });
    return by_setting || std::any_of(touched.read.begin(), touched.read.end(), [&](StateId state) {
             return count(set_by_, state) > (is_in(touched.set, state) ? 1U : 0U);
           });
  }

private:
  std::unordered_map<StateId, std::size_t> set_by_, read_by_; ///< tasks
};

bool has_priority(const Model& model, const Task& task) {
  return model.any_level(task, [](const Level& level) { return level.priority != 0; });
}

std::string beside(const Model& model, const Together& together) {
  if (!together.provider) return "no other root";
  if (together.pack.empty()) return fmt::format("no other task of {}", name_of(model, *together.provider));
  return fmt::format("no other task of the pack `{}`", together.pack);
}

/// Tasks of a provider are still requested while another provider of its group begins to run. So they are compared with
/// what that one needs, which counts with the first priority that the group gives it.
class OtherProviders {
public:
  OtherProviders(const Model& model, const Together& together) : model_(model) {
    if (!together.provider) return;
    provider_ = *together.provider;
    for (const ProviderId id : model.groups[model.providers[provider_].group].providers) {
      if (id != provider_) others_.push_back(id);
    }
  }

  /// What is compared with this task.
  std::vector<GroupId> beside(GroupId task) const {
    std::vector<GroupId> out;
    const bool is_needed = !others_.empty() && model_.providers[provider_].needs_group(task);
    for (const ProviderId id : others_) {
      const Provider& other = model_.providers[id];
      for (const Use<GroupId>& need : other.needs) out.push_back(need.id);
      if (!is_needed && !other.needs_group(task)) continue;
      for (const Pack& pack : other.packs) {
        for (const Task& each : pack.tasks) out.push_back(each.target);
      }
    }
    std::erase(out, task);
    return out;
  }

private:
  const Model& model_;
  ProviderId provider_{};
  std::vector<ProviderId> others_;
};

/// The entries of one edge: tasks of several packs.
struct Entries {
  std::size_t all = 0;
  std::vector<std::pair<const Together*, const Task*>> undisputed; ///< that have a priority
};

/// A level is a place in the order of its edge, and `keep` continues a task only at the same one. So an edge is
/// reported as a whole, if it has one level.
void look_at(const Input& input, const Together& together, TouchedStates& states, AffectedGroups& affected,
             std::map<EdgeId, Entries>& entries) {
  const Model& model = input.model;
  const std::vector<Task>& tasks = *together.tasks;
  for (const Task& task : tasks) ++entries[task.edge].all;
  if (std::none_of(tasks.begin(), tasks.end(), [&](const Task& task) { return has_priority(model, task); })) return;
  std::unordered_map<GroupId, std::size_t> wanted_by;
  for (const Task& task : tasks) {
    for (const GroupId group : affected.of(task.target)) ++wanted_by[group];
  }
  const OtherProviders others(model, together);
  const SharedStates shared(states, tasks);
  const auto is_disputed = [&](GroupId task) {
    const std::vector<GroupId>& own = affected.of(task); // later calls do not move it
    if (std::any_of(own.begin(), own.end(), [&](GroupId group) { return wanted_by[group] > 1; })) return true;
    if (shared.matter_for(states.of(task))) return true;
    SparseSet<GroupId> ours;
    for (const GroupId group : own) ours.add(group);
    const std::vector<GroupId> compared = others.beside(task);
    return std::any_of(compared.begin(), compared.end(), [&](GroupId other) {
      const std::vector<GroupId>& theirs = affected.of(other);
      return std::any_of(theirs.begin(), theirs.end(), [&](GroupId group) { return ours.contains(group); });
    });
  };
  const auto is_member = [&](const Task& task) { return together.provider && model.may_be_member(task); };
  // A unit is tried at the place of its first member.
  const bool unit_is_disputed = std::any_of(
      tasks.begin(), tasks.end(), [&](const Task& task) { return is_member(task) && is_disputed(task.target); });
  for (const Task& task : tasks) {
    if (has_priority(model, task) && !is_disputed(task.target) && !(unit_is_disputed && is_member(task)))
      entries[task.edge].undisputed.emplace_back(&together, &task);
  }
}

} // namespace

void priority_without_effect(const Input& input, Findings& findings) {
  AffectedGroups affected(input);
  TouchedStates states(input);
  const Model& model = input.model;
  std::map<EdgeId, Entries> entries;
  for (const Together& together : input.shared.chains().together()) look_at(input, together, states, affected, entries);
  for (const auto& [edge, found] : entries) {
    if (found.undisputed.size() != found.all || model.edges[edge].levels.size() != 1) continue;
    for (const auto& [together, task] : found.undisputed) {
      findings
          .add(task->span, fmt::format("the priority of {} decides nothing: {} may ever want the same group",
                                       name_of(model, task->target), beside(model, *together)))
          .help = fmt::format("remove it{}, so that the priorities that are written are those that count",
                              found.all == 1 ? "" : " in each pack");
    }
  }
}

} // namespace director::checks
