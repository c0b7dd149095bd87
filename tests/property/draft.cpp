// Header: tests/property/draft.hpp. Test: tests/property/generate_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/draft.hpp"

namespace director::property {

std::string to_text(const BehaviourDraft& draft, const ConditionDraft& condition) {
  const StateDraft& state = draft.states[condition.state];
  std::string out = state.name;
  if (condition.op.empty()) return out;
  char before = ' ';
  out += " " + condition.op;
  for (const std::size_t value : condition.values) out += before + state.values[value], before = '|';
  if (condition.within) out += " within " + std::to_string(*condition.within) + " ms";
  return out;
}

namespace {

Node conditions(const BehaviourDraft& draft, const std::vector<ConditionDraft>& list) {
  Node out = Node::list();
  for (const ConditionDraft& condition : list) out.add(to_text(draft, condition));
  return out;
}

Node names(const BehaviourDraft& draft, const std::vector<std::size_t>& groups) {
  Node out = Node::list();
  for (const std::size_t group : groups) out.add(draft.groups[group].name);
  return out;
}

Node of(const LevelDraft& level) {
  Node out;
  if (level.priority != 0) out.add("priority", std::to_string(level.priority));
  if (level.optional) out.add("optional", "true");
  if (level.apart) out.add("apart", "true");
  return out;
}

Node of(const TaskDraft& task) {
  if (task.levels.size() == 1) return of(task.levels.front());
  Node out;
  Node& levels = out.add("levels", {});
  for (const LevelDraft& level : task.levels) levels.add(level.name, of(level));
  return out;
}

Node tasks(const BehaviourDraft& draft, const std::vector<TaskDraft>& list) {
  Node out;
  for (const TaskDraft& task : list) out.add(draft.groups[task.target].name, of(task));
  return out;
}

void add_words(const BehaviourDraft& draft, const ProviderDraft& provider, Node& out) {
  out.add_some("when", conditions(draft, provider.when));
  out.add_some("stay", conditions(draft, provider.stay));
  out.add_some("needs", names(draft, provider.needs));
  out.add_some("causing", conditions(draft, provider.causing));
  out.add_some("sets", conditions(draft, provider.sets));
  out.add_some("triggers", Node::list(provider.triggers));
  if (provider.every) out.add("every", std::to_string(*provider.every) + " ms");
  out.add_some("uses", names(draft, provider.uses));
  if (provider.packs.size() == 1 && provider.packs.front().name.empty()) {
    out.add_some("tasks", tasks(draft, provider.packs.front().tasks));
  } else if (!provider.packs.empty()) {
    Node& packs = out.add("packs", {});
    for (const PackDraft& pack : provider.packs) packs.add(pack.name, tasks(draft, pack.tasks));
  }
}

Node handler(const BehaviourDraft& draft, const std::vector<ConditionDraft>& sets) {
  if (sets.empty()) return "true";
  Node out;
  out.add("sets", conditions(draft, sets));
  return out;
}

Node of(const BehaviourDraft& draft, const GroupDraft& group) {
  Node out;
  if (group.data) out.add("data", "int");
  if (group.start) out.add("start", handler(draft, group.start_sets));
  if (group.stop) out.add("stop", handler(draft, group.stop_sets));
  if (group.providers.size() == 1 && group.providers.front().name == "default") {
    add_words(draft, group.providers.front(), out);
    return out;
  }
  out.add_some("triggers", Node::list(group.triggers));
  Node& providers = out.add("providers", Node::list());
  for (const ProviderDraft& provider : group.providers) {
    Node& each = providers.add(Node());
    each.add("name", provider.name);
    add_words(draft, provider, each);
  }
  return out;
}

Node of(const BehaviourDraft& draft, const StateDraft& state) {
  Node out;
  if (state.is_range) {
    out.add("range", Node::list({state.values.front(), state.values.back()}));
  } else {
    out.add("values", Node::list(state.values));
  }
  if (state.first_unordered) out.add("unordered", Node::list({state.values.front()}));
  if (state.initial) out.add("initial", state.values[*state.initial]);
  if (state.external) out.add("external", "true");
  if (state.expires) {
    const std::string after = std::to_string(*state.expires) + " ms";
    if (state.expires_to) {
      Node& expires = out.add("expires", {});
      expires.add("after", after);
      expires.add("to", state.values[*state.expires_to]);
    } else {
      out.add("expires", after);
    }
  }
  if (state.owner) out.add("of", draft.groups[*state.owner].name);
  return out;
}

} // namespace

Node to_document(const BehaviourDraft& draft) {
  Node out;
  out.add("behaviour", "random_case");
  out.add("language", "1");
  Node& states = out.add("states", {});
  for (const StateDraft& state : draft.states) states.add(state.name, of(draft, state));
  out.add_some("triggers", Node::list(draft.triggers));
  out.add("roots", tasks(draft, draft.roots));
  Node& groups = out.add("groups", {});
  for (const GroupDraft& group : draft.groups) groups.add(group.name, of(draft, group));
  return out;
}

} // namespace director::property
