// Header: compiler/model/resolve/resolver.hpp. Test: compiler/checks/unused_declaration.md.
// SPDX-License-Identifier: MIT
#include "compiler/model/resolve/resolver.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

/// `rules_out`: as in a finding.
void report(Resolver& r, Span span, std::string message, std::string help, std::vector<Span> rules_out = {}) {
  if (span.file != r.main.file) return; // a shared module has other importers, which may use it
  r.find("unused_declaration", dsl::Level::lint, span, std::move(message), std::move(help)).rules_out =
      std::move(rules_out);
}

/// Reports that it never runs.
void report_group(Resolver& r, Span span, std::string message) {
  report(r, span, std::move(message),
         "remove it, or list it under `roots`, or under `tasks` or `needs` of another group", {span});
}

/// A state that is only set has no effect: bodies do not read states.
void find_unused_states(Resolver& r) {
  std::vector<bool> compared(r.model.states.size(), false);
  for (const Provider& provider : r.model.providers) {
    for (const auto* list : {&provider.when, &provider.stay}) {
      for (const ConditionUse& use : *list) compared[r.model.conditions[use.id].state.value] = true;
    }
  }
  for (const StateId id : r.model.states.ids()) {
    const Word& name = r.model.states[id].name;
    if (!compared[id.value])
      report(r, name.span, fmt::format("no condition looks at the state `{}`", name.value),
             "remove it, or let a `when` test it");
  }
}

void find_unused_triggers(Resolver& r) {
  std::vector<bool> listened(r.model.triggers.size(), false);
  for (const Provider& provider : r.model.providers) {
    for (const Use<TriggerId>& use : provider.triggers) listened[use.id.value] = true;
  }
  for (const TriggerId id : r.model.triggers.ids()) {
    const Trigger& trigger = r.model.triggers[id];
    if (!listened[id.value])
      report(r, trigger.span, fmt::format("no provider listens to the trigger `{}`", trigger.name),
             "remove it, or list it under `triggers` of the provider that it should run again");
  }
}

void find_unused_layers(Resolver& r) {
  std::vector<bool> used(r.model.layers.size(), false);
  for (const Group& group : r.model.groups) {
    if (group.layer) used[group.layer->id.value] = true;
  }
  for (const LayerId id : r.model.layers.ids()) {
    const Word& name = r.model.layers[id].name;
    if (!used[id.value])
      report(r, name.span, fmt::format("no group is in the layer `{}`", name.value),
             "remove it, or say `layer` at the groups that belong to it");
  }
}

/// All groups that these lead to, by requests and needs; these included.
std::vector<bool> led_to(const Model& model, std::vector<GroupId> open) {
  std::vector<bool> out(model.groups.size(), false);
  for (const GroupId id : open) out[id.value] = true;
  for (std::size_t next = 0; next < open.size(); ++next) {
    for (const EdgeId edge : model.groups[open[next]].edges) {
      const GroupId target = model.edges[edge].target;
      if (!out[target.value]) open.push_back(target);
      out[target.value] = true;
    }
  }
  return out;
}

/// Groups that only lead to each other.
void find_unused_cycles(Resolver& r) {
  const Model& model = r.model;
  std::vector<GroupId> from;
  for (const Task& root : model.roots) from.push_back(root.target);
  for (const GroupId id : model.groups.ids()) {
    if (model.groups[id].requesters.empty()) from.push_back(id); // reported
  }
  const std::vector<bool> used = led_to(model, from);
  std::vector<bool> done = used;
  for (const GroupId id : model.groups.ids()) {
    if (done[id.value]) continue;
    const std::vector<bool> below = led_to(model, {id});
    // The first group of a cycle to which no other cycle leads.
    const std::vector<EdgeId>& above = model.groups[id].requesters;
    std::vector<GroupId> open;
    for (const EdgeId edge : above) open.push_back(*model.edges[edge].requester);
    std::vector<bool> seen(model.groups.size(), false);
    bool is_top = true;
    for (std::size_t next = 0; next < open.size() && is_top; ++next) {
      if (seen[open[next].value]) continue;
      seen[open[next].value] = true;
      is_top = below[open[next].value];
      for (const EdgeId edge : model.groups[open[next]].requesters) open.push_back(*model.edges[edge].requester);
    }
    if (!is_top) continue;
    for (const GroupId each : model.groups.ids()) done[each.value] = done[each.value] || below[each.value];
    const std::string& name = model.groups[id].name.value;
    report_group(r, model.groups[id].name.span,
                 fmt::format("nothing requests or needs `{}` but what it leads to itself", name));
  }
}

void find_unused_groups(Resolver& r) {
  for (const Group& group : r.model.groups) {
    if (group.requesters.empty())
      report_group(r, group.name.span, fmt::format("nothing requests or needs `{}`", group.name.value));
  }
  find_unused_cycles(r);
}

} // namespace

/// A module that is checked alone may have importers that use it.
void find_unused(Resolver& r) {
  if (!r.model.deployment) return;
  find_unused_states(r);
  find_unused_triggers(r);
  find_unused_layers(r);
  find_unused_groups(r);
}

} // namespace director::compiler
