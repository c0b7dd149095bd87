// Header: tests/property/generate.hpp. Test: tests/property/generate_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/generate.hpp"

#include <algorithm>

namespace director::property {

namespace {

class ScenarioWriter {
public:
  ScenarioWriter(Random& random, const Flavour& flavour, const BehaviourDraft& behaviour)
      : r_(random),
        f_(flavour),
        b_(behaviour) {}

  Node write() {
    Node out;
    out.add("scenario", "random");
    out.add("behaviour", "behaviour.yaml");
    if (r_.chance(0.2)) out.add("given", some_values(all_states(false), 1, 2));
    Node& script = out.add("script", {});
    for (const GroupDraft& group : b_.groups) {
      for (const ProviderDraft& provider : group.providers) {
        const bool bare = provider.name == "default";
        script.add(group.name + (bare ? "" : "." + provider.name), cases(group, provider));
      }
      if (!group.start_sets.empty()) script.add(group.name + ".start", handler_cases(group.start_sets));
      if (!group.stop_sets.empty()) script.add(group.name + ".stop", handler_cases(group.stop_sets));
    }
    Node& steps = out.add("steps", Node::list());
    for (int i = r_.between(10, 30) * f_.length; i > 0; --i) steps.add(step());
    return out;
  }

private:
  // Script

  Node cases(const GroupDraft& group, const ProviderDraft& provider) {
    Node out = Node::list();
    for (int run = 1; run <= f_.scripted_runs; ++run) {
      if (r_.chance(0.4)) out.add(guarded(group, provider, run));
      Node plain;
      plain.add("run", std::to_string(run));
      out.add(effect(provider, plain));
    }
    Node rest;
    rest.add("continue", "true");
    out.add(rest);
    return out;
  }

  Node guarded(const GroupDraft& group, const ProviderDraft& provider, int run) {
    Node guard;
    guard.add("run", std::to_string(run));
    if (!provider.uses.empty() && r_.chance(0.4)) {
      Node& uses = guard.add("uses", {});
      uses.add(b_.groups[r_.one_of(provider.uses)].name, r_.one_of({"running", "queued", "none", "done", "failed"}));
    } else if (!provider.triggers.empty() && r_.chance(0.4)) {
      guard.add("trigger", provider.triggers.front());
    } else if (group.data && r_.chance(0.5)) {
      guard.add("data", data());
    } else {
      guard.add("reason", r_.one_of({"new_task", "pushed", "subtask_done", "wait", "trigger"}));
    }
    return effect(provider, guard);
  }

  Node handler_cases(const std::vector<ConditionDraft>& sets) {
    Node out = Node::list();
    for (int run = 1; run <= f_.scripted_runs; ++run) {
      Node each;
      each.add("run", std::to_string(run));
      each.add("set", {}).add(b_.states[sets.front().state].name, value_for(sets.front()));
      out.add(each);
    }
    return out;
  }

  Node effect(const ProviderDraft& provider, Node out) {
    Node set;
    if (!provider.causing.empty() && r_.chance(f_.diligence)) add_setting(r_.one_of(provider.causing), set);
    if (!provider.sets.empty() && r_.chance(0.4)) add_setting(provider.sets.front(), set);
    out.add_some("set", set);
    const std::size_t answer = r_.below(100);
    if (answer < 5) {
      out.add("done", "true");
    } else if (answer < 7) {
      out.add("failed", "true");
    } else if (answer < 13) {
      out.add("continue", "true");
    } else {
      add_pack(provider, out);
    }
    if (r_.chance(0.07)) out.add("wait", std::string(r_.one_of({"10 ms", "25 ms", "50 ms"})));
    return out;
  }

  void add_setting(const ConditionDraft& condition, Node& set) {
    const std::string& name = b_.states[condition.state].name;
    if (set.find(name) == nullptr) set.add(name, value_for(condition));
  }

  /// A value that satisfies a condition as bodies declare it: ==, >= or any.
  std::string value_for(const ConditionDraft& condition) {
    const StateDraft& state = b_.states[condition.state];
    if (condition.op.empty()) return r_.one_of(state.values);
    if (condition.op == ">=") {
      const std::size_t low = condition.values.front();
      return state.values[low + r_.below(state.values.size() - low)];
    }
    return state.values[r_.one_of(condition.values)];
  }

  void add_pack(const ProviderDraft& provider, Node& out) {
    if (provider.packs.empty()) return;
    const PackDraft& pack = r_.one_of(provider.packs);
    Node entries = Node::list();
    for (const TaskDraft& task : pack.tasks) {
      Node entry = request(task, true);
      if (pack.name.empty() ? r_.chance(0.85) : entry.kind != Node::Kind::word) entries.add(entry);
    }
    if (pack.name.empty()) {
      out.add("tasks", entries);
    } else {
      out.add("pack", pack.name);
      out.add_some("with", entries);
    }
  }

  /// A name, or {name: {level, data, keep}}.
  Node request(const TaskDraft& task, bool may_keep) {
    const GroupDraft& target = b_.groups[task.target];
    Node detail;
    if (task.levels.size() > 1 && r_.chance(0.6)) detail.add("level", r_.one_of(task.levels).name);
    if (target.data && r_.chance(0.6)) detail.add("data", data());
    if (may_keep && r_.chance(0.12)) detail.add("keep", "true");
    if (detail.empty()) return target.name;
    Node out;
    out.add(target.name, detail);
    return out;
  }

  Node data() { return std::to_string(r_.between(1, 3)); }

  // Steps

  Node step() {
    if (r_.chance(0.1)) {
      Node out;
      out.add("advance", r_.one_of({"10 ms", "30 ms", "100 ms"}));
      return out;
    }
    if (r_.chance(0.1)) {
      Node out;
      Node& inputs = out.add("inputs", Node::list());
      for (int i = r_.between(2, 3); i > 0; --i) inputs.add(input());
      return out;
    }
    return input();
  }

  Node input() {
    Node out;
    const std::size_t kind = r_.below(100);
    if (kind < 34) {
      const std::vector<TaskDraft> roots = r_.some(b_.roots, 1, r_.chance(0.2) ? 3 : 1);
      if (roots.size() == 1) {
        out.add("request", request(roots.front(), false));
      } else {
        Node& list = out.add("request", Node::list());
        for (const TaskDraft& root : roots) list.add(b_.groups[root.target].name);
      }
    } else if (kind < 41) {
      out.add("cancel", b_.groups[r_.one_of(b_.roots).target].name);
    } else if (kind < 80) {
      out.add("set", some_values(all_states(true), 1, 2));
    } else if (kind < 86 && !b_.triggers.empty()) {
      out.add("trigger", r_.one_of(b_.triggers));
    } else {
      const GroupDraft& group = r_.one_of(b_.groups);
      // Twice as many are enabled: most enables change nothing.
      out.add(r_.chance(0.35) ? "disable" : "enable", group.name + "." + r_.one_of(group.providers).name);
    }
    return out;
  }

  std::vector<std::size_t> all_states(bool external) const {
    std::vector<std::size_t> out;
    for (std::size_t s = 0; s < b_.states.size(); ++s) {
      if (!external || b_.states[s].external) out.push_back(s);
    }
    return out;
  }

  Node some_values(const std::vector<std::size_t>& states, int low, int high) {
    Node out;
    for (const std::size_t s : r_.some(states, low, high)) out.add(b_.states[s].name, r_.one_of(b_.states[s].values));
    return out;
  }

  Random& r_;
  const Flavour& f_;
  const BehaviourDraft& b_;
};

} // namespace

Node random_scenario(Random& random, const Flavour& flavour, const BehaviourDraft& behaviour) {
  return ScenarioWriter(random, flavour, behaviour).write();
}

} // namespace director::property
