// Header: compiler/analysis/equals/withheld.hpp. Test: compiler/checks/equal_priority.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/equals/withheld.hpp"

#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace director::analysis {

namespace {

/// Limit for the edges that are followed, for all tasks together. A real behaviour of 10,000 groups takes a hundredth.
constexpr std::size_t most_edges = 10'000'000;

/// What a preferred provider must have, and where it can run.
struct Preferred {
  ProviderId provider{};
  const Use<GroupId>* need = nullptr;
  GroupId group{};
  std::int32_t priority = 0; ///< of the need
  Region region;
};

class Search {
public:
  explicit Search(const Input& input) : input_(input), model_(input.model) {}

  std::vector<WithheldNeed> run() {
    for (const GroupId group : model_.groups.ids()) look_at(group);
    return std::move(out_);
  }

private:
  void look_at(GroupId group) {
    std::vector<Preferred> wanting;
    const std::vector<ProviderId>& providers = model_.groups[group].providers;
    for (const ProviderId id : providers) {
      if (!input_.facts.active.contains(id)) continue;
      if (!wanting.empty()) look_at_tasks(id, wanting);
      if (id != providers.back()) add_wanting(id, wanting); // none is preferred to anything behind the last one
    }
  }

  /// A need counts as a request at the first level of its edge.
  std::int32_t priority_of_need(GroupId group, GroupId need) const {
    const std::vector<EdgeId>& edges = model_.groups[group].edges;
    const auto at =
        std::find_if(edges.begin(), edges.end(), [&](EdgeId id) { return model_.edges[id].target == need; });
    const std::vector<Level>& levels = model_.edges[*at].levels;
    return levels.empty() ? 0 : levels.front().priority;
  }

  void add_wanting(ProviderId id, std::vector<Preferred>& wanting) const {
    const Provider& provider = model_.providers[id];
    const Region region = region_of(model_, provider.when);
    for (const Use<GroupId>& need : provider.needs) {
      Region with_need = region;
      with_need.meet(input_.shared.branches().grantable(need.id));
      const auto& parts = input_.shared.indispensable().of(need.id);
      if (with_need.empty() || !parts) continue;
      const std::int32_t priority = priority_of_need(provider.group, need.id);
      for (const GroupId part : *parts) wanting.push_back({id, &need, part, priority, with_need});
    }
  }

  /// What another task of the pack always holds is not held by this one.
  bool is_taken_beside(const Pack& pack, const Task& task, GroupId group) const {
    return std::any_of(pack.tasks.begin(), pack.tasks.end(), [&](const Task& other) {
      return other.edge != task.edge && !model_.may_be_left_out(other) &&
             input_.shared.indispensable().contains(other.target, group);
    });
  }

  void look_at_tasks(ProviderId id, const std::vector<Preferred>& wanting) {
    const Provider& running = model_.providers[id];
    for (const Pack& pack : running.packs) {
      for (const Task& task : pack.tasks) {
        std::optional<Claims> claims;
        for (const Preferred& each : wanting) {
          // What is requested as the need itself is the same edge, and stays. What the provider needs its tasks do not
          // hold.
          if (each.need->id == task.target || input_.shared.indispensable().needs_contain(running, each.group) ||
              is_taken_beside(pack, task, each.group))
            continue;
          if (look_at_task(id, task, each, claims)) break;
        }
      }
    }
  }

  /// Whether a provider between the two can run in the whole region: then the group changes to that one first.
  bool is_left_for_another(ProviderId running, ProviderId wanting, const Region& region) const {
    for (const ProviderId id : model_.groups[model_.providers[running].group].providers) {
      const bool is_between = wanting < id && id < running && input_.facts.active.contains(id);
      if (is_between && contains(region_of(model_, model_.providers[id].when), region)) return true;
    }
    return false;
  }

  /// `claims`: of the task, found when they are first asked for.
  bool look_at_task(ProviderId id, const Task& task, const Preferred& wanting, std::optional<Claims>& claims) {
    const std::vector<Level>& levels = model_.edges[task.edge].levels;
    const auto level = std::find_if(task.levels.begin(), task.levels.end(), [&](const Task::NamedLevel& named) {
      return !levels[named.level].optional && levels[named.level].priority == wanting.priority;
    });
    Region region = active_region(model_, model_.providers[id]);
    region.meet(wanting.region);
    if (level == task.levels.end() || region.empty() || is_left_for_another(id, wanting.provider, region)) return false;
    if (!claims) {
      if (effort_ > most_edges) {
        leave_open(task);
        return false;
      }
      claims.emplace(input_.shared.branches(), task.target, std::vector<GroupId>{model_.providers[id].group});
      effort_ += claims->effort();
    }
    for (const Reach reach : {Reach::own, Reach::mandatory}) {
      const Claim* claim = claims->find(wanting.group, reach);
      if (claim == nullptr || !compatible(claim->region, region)) continue;
      out_.push_back({wanting.provider, wanting.need, id, &task, wanting.group, levels[level->level],
                      claims->path(wanting.group, reach)});
      return true;
    }
    return false;
  }

  /// Recorded once for all tasks from there on.
  void leave_open(const Task& task) {
    if (std::exchange(is_open_, true)) return;
    input_.shared.budget().leave_open(task.span,
                                      fmt::format("whether a task holds what a preferred provider of its requester "
                                                  "needs, from {} on",
                                                  name_of(model_, task.target)));
  }

  const Input& input_;
  const Model& model_;
  std::vector<WithheldNeed> out_;
  std::size_t effort_ = 0;
  bool is_open_ = false;
};

} // namespace

std::vector<WithheldNeed> find_withheld_needs(const Input& input) { return Search(input).run(); }

} // namespace director::analysis
