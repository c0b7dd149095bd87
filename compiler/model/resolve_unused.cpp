// Door: compiler/model/resolver.hpp. Test: compiler/checks/unused_declaration.md.
// SPDX-License-Identifier: MIT
#include "compiler/model/resolver.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

void report(Resolver& r, Span span, std::string message, std::string help) {
  if (span.file != r.main.file) return; // a shared module has other importers, who may use it
  r.find("unused_declaration", dsl::Level::lint, span, std::move(message), std::move(help));
}

/// A state that is only set tells nobody anything: bodies do not read states.
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
             "remove it, or say in a `when` who waits for it");
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

void find_unused_groups(Resolver& r) {
  for (const Group& group : r.model.groups) {
    if (group.requesters.empty())
      report(r, group.name.span, fmt::format("nothing requests or needs `{}`", group.name.value),
             "remove it, or list it under `roots`, or under `tasks` or `needs` of another group");
  }
}

} // namespace

/// Of a module that is checked alone nobody knows what its importers will use.
void find_unused(Resolver& r) {
  if (!r.model.deployment) return;
  find_unused_states(r);
  find_unused_triggers(r);
  find_unused_layers(r);
  find_unused_groups(r);
}

} // namespace director::compiler
