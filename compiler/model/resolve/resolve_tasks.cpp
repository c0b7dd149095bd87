// Header: compiler/model/resolve/resolver.hpp. Test: tests/compiler/model/resolve/resolve_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/resolve/resolver.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

namespace {

EdgeId declare_edge(Resolver& r, std::optional<GroupId> requester, GroupId target, Span span) {
  const auto [at, is_new] =
      r.edges.try_emplace({requester, target}, EdgeId{static_cast<std::uint32_t>(r.model.edges.size())});
  if (is_new) {
    Edge edge;
    edge.requester = requester;
    edge.target = target;
    edge.span = span;
    r.model.edges.add(std::move(edge));
    if (requester) r.model.groups[*requester].edges.push_back(at->second);
    r.model.groups[target].requesters.push_back(at->second);
  }
  return at->second;
}

/// The index of a level among the different ones of its edge.
std::uint32_t declare_level(Edge& edge, const Level& level) {
  const auto at = std::find(edge.levels.begin(), edge.levels.end(), level);
  const auto place = static_cast<std::uint32_t>(at - edge.levels.begin());
  if (at == edge.levels.end()) edge.levels.push_back(level);
  return place;
}

/// A level becomes a constant of the task's type, beside the contexts of the task's providers.
void check_level_name(Resolver& r, const Word& name, GroupId target) {
  if (!check_name(r, "level", name)) return;
  const std::string& group = r.model.groups[target].name.value;
  for (const dsl::ProviderSpec* provider : r.group_sources[target].providers) {
    if (capitalised(provider->name.value) != capitalised(name.value)) continue;
    r.error(
         "redefined_name", name.span,
         fmt::format("the level `{}` is called like a provider of `{}`, the group that it requests", name.value, group),
         "give the level another name")
        .notes.push_back({provider->name.span, "the provider is declared here"});
    return;
  }
  if (name.value == capitalised(group)) {
    r.error("redefined_name", name.span,
            fmt::format("the level `{}` is called like the group that it requests", name.value),
            "give the level another name")
        .notes.push_back({r.model.groups[target].name.span, "the group is declared here"});
  }
}

std::optional<Task> resolve_task(Resolver& r, std::optional<GroupId> requester, const dsl::TaskSpec& spec) {
  const auto target = find_group(r, spec.name);
  if (!target) return std::nullopt;
  Task task;
  task.target = *target;
  task.span = spec.name.span;
  task.edge = declare_edge(r, requester, *target, spec.name.span);
  if (spec.doc) task.doc = spec.doc->value;
  for (const dsl::LevelSpec& level : spec.levels) {
    if (!level.name.value.empty()) check_level_name(r, level.name, *target);
    const Level value{level.priority.value, level.optional.value, level.apart.value};
    task.levels.push_back({level.name.value, declare_level(r.model.edges[task.edge], value), level.name.span});
  }
  return task;
}

} // namespace

std::vector<Task> resolve_tasks(Resolver& r, std::optional<GroupId> requester,
                                const std::vector<dsl::TaskSpec>& specs) {
  std::vector<Task> out;
  for (const dsl::TaskSpec& spec : specs) {
    auto task = resolve_task(r, requester, spec);
    if (!task) continue;
    const auto first =
        std::find_if(out.begin(), out.end(), [&](const Task& other) { return other.edge == task->edge; });
    if (first != out.end()) {
      r.error("redefined_name", spec.name.span, fmt::format("`{}` is listed twice", spec.name.value),
              "leave one of them out")
          .notes.push_back({first->span, "listed first here"});
      continue;
    }
    out.push_back(*std::move(task));
  }
  return out;
}

void declare_need(Resolver& r, GroupId requester, const Use<GroupId>& need) {
  r.model.edges[declare_edge(r, requester, need.id, need.span)].needed = true;
}

void resolve_roots(Resolver& r) {
  if (r.main.roots) r.model.roots = resolve_tasks(r, std::nullopt, *r.main.roots);
}

} // namespace director::compiler
