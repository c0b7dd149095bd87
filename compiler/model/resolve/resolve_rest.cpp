// Header: compiler/model/resolve/resolver.hpp. Test: tests/compiler/model/resolve/resolve_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/resolve/resolver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace director::compiler {

namespace {

/// The groups that some chain of tasks from a root leads to, whatever the conditions.
std::vector<bool> requestable(const Model& model) {
  std::vector<bool> out(model.groups.size(), false);
  std::vector<GroupId> open;
  const auto reach = [&](const Edge& edge) {
    if (edge.levels.empty() || out[edge.target.value]) return;
    out[edge.target.value] = true;
    open.push_back(edge.target);
  };
  for (const Task& root : model.roots) reach(model.edges[root.edge]);
  while (!open.empty()) {
    const GroupId group = open.back();
    open.pop_back();
    for (const EdgeId edge : model.groups[group].edges) reach(model.edges[edge]);
  }
  return out;
}

Assertion::Kind kind_of(dsl::AssertionSpec::Kind kind) {
  switch (kind) {
  case dsl::AssertionSpec::Kind::never_together: return Assertion::Kind::never_together;
  case dsl::AssertionSpec::Kind::beats: return Assertion::Kind::beats;
  case dsl::AssertionSpec::Kind::can_run: return Assertion::Kind::can_run;
  case dsl::AssertionSpec::Kind::soft: return Assertion::Kind::soft;
  }
  return Assertion::Kind::can_run;
}

/// Assertions of an imported file count if all their groups can be requested.
void resolve_assertions(Resolver& r) {
  const std::vector<bool> can_be_requested = requestable(r.model);
  for (const dsl::BehaviourSpec& file : r.spec.files) {
    for (const dsl::AssertionSpec& spec : file.assertions) {
      Assertion assertion;
      assertion.kind = kind_of(spec.kind.value);
      assertion.span = spec.span;
      for (const Word& name : spec.groups) {
        const auto group = find_group(r, name);
        if (!group && r.groups.count(name.value.substr(0, name.value.find('.'))) != 0)
          r.findings.back().help = "an assertion is about groups; `directorc explore` lists providers that never run";
        if (!group) continue;
        const auto first = std::find_if(assertion.groups.begin(), assertion.groups.end(),
                                        [&](Use<GroupId> use) { return use.id == *group; });
        if (first != assertion.groups.end())
          r.error("redefined_name", name.span, fmt::format("`{}` is named twice", name.value),
                  "an assertion is about different groups")
              .notes.push_back({first->span, "named first here"});
        assertion.groups.push_back({*group, name.span});
      }
      const bool counts =
          &file == &r.main || std::all_of(assertion.groups.begin(), assertion.groups.end(),
                                          [&](Use<GroupId> use) { return can_be_requested[use.id.value]; });
      if (counts) r.model.assertions.push_back(std::move(assertion));
    }
  }
}

/// The generated C++ numbers the named levels of a task, those of all its requesters together, in a byte.
void limit_level_names(Resolver& r) {
  constexpr std::size_t most = 255;
  IdTable<GroupId, std::set<std::string_view>> names(r.model.groups.size());
  const auto add = [&](const Task& task) {
    for (const Task::NamedLevel& level : task.levels) {
      std::set<std::string_view>& known = names[task.target];
      if (level.name.empty() || !known.insert(level.name).second || known.size() != most + 1) continue;
      r.error("input_limit", level.span,
              fmt::format("`{}` has more than {} named levels", r.model.groups[task.target].name.value, most),
              "use fewer names: those of all its requesters count, each once");
    }
  };
  for (const Task& root : r.model.roots) add(root);
  for (const Provider& provider : r.model.providers) {
    for (const Pack& pack : provider.packs) {
      for (const Task& task : pack.tasks) add(task);
    }
  }
}

void add_allowances(Resolver& r, const std::vector<dsl::AllowSpec>& specs, Span scope) {
  for (const dsl::AllowSpec& spec : specs) {
    const std::vector<std::string>& known = r.options.check_ids;
    if (!known.empty() && std::find(known.begin(), known.end(), spec.id.value) == known.end()) {
      report_undefined(r, "check", spec.id, known);
      continue;
    }
    r.model.allowances.push_back({spec.id, scope});
  }
}

void add_allowances_of_tasks(Resolver& r, const std::vector<dsl::TaskSpec>& tasks) {
  for (const dsl::TaskSpec& task : tasks) add_allowances(r, task.allow, task.span);
}

void add_allowances_of_providers(Resolver& r, const std::vector<dsl::ProviderSpec>& providers) {
  for (const dsl::ProviderSpec& provider : providers) {
    if (!provider.direct) add_allowances(r, provider.allow, provider.span);
    if (provider.tasks) add_allowances_of_tasks(r, *provider.tasks);
    if (!provider.packs) continue;
    for (const dsl::PackSpec& pack : *provider.packs) add_allowances_of_tasks(r, pack.tasks);
  }
}

void resolve_allowances(Resolver& r) {
  for (const dsl::BehaviourSpec& file : r.spec.files) {
    add_allowances(r, file.allow, file.span);
    for (const dsl::StateSpec& state : file.states) add_allowances(r, state.allow, state.span);
    if (file.roots) add_allowances_of_tasks(r, *file.roots);
    for (const dsl::GroupSpec& group : file.groups) {
      add_allowances(r, group.allow, group.span);
      add_allowances_of_providers(r, group.providers);
    }
    for (const dsl::ExtendSpec& extend : file.extend) add_allowances_of_providers(r, extend.providers);
  }
}

/// The roots of imported files request nothing; their names have to exist nevertheless.
void check_roots_of_imports(Resolver& r) {
  for (const dsl::BehaviourSpec& file : r.spec.files) {
    if (&file == &r.main || !file.roots) continue;
    Resolver scratch = r;
    resolve_tasks(scratch, std::nullopt, *file.roots);
    r.findings = std::move(scratch.findings);
  }
}

} // namespace

void resolve_rest(Resolver& r) {
  limit_level_names(r);
  resolve_assertions(r);
  resolve_allowances(r);
  check_roots_of_imports(r);
}

} // namespace director::compiler
