// Header: compiler/model/print_model.hpp. Test: tests/compiler/model/print_model_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/print_model.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

namespace {

class Printer {
public:
  explicit Printer(const Model& model) : model_(model) {}

  std::string run() {
    line("behaviour {}{}", model_.name, model_.deployment ? "" : " (a module)");
    line("namespace {}", model_.name_space);
    for (const std::string& header : model_.headers) line("header {}", header);
    line("trials {}, in a pass {}", model_.trials.most, model_.pass.most);
    for (const Layer& layer : model_.layers) line("layer {}", layer.name.value);
    for (const State& state : model_.states) print(state);
    for (const Trigger& trigger : model_.triggers)
      line("trigger {}{}", trigger.name, trigger.promise ? " (a promise)" : "");
    for (const Use<GroupId>& use : model_.externs) line("extern {}", name(use.id));
    for (const Task& root : model_.roots) line("root {}", task(root));
    for (const Module& module : model_.modules) line("module {}: {}", module.name, names(module.groups));
    for (const Group& group : model_.groups) print(group);
    for (const EdgeId edge : model_.edges.ids()) print(edge);
    for (const Assertion& assertion : model_.assertions) print(assertion);
    for (const Allowance& allowance : model_.allowances) line("allow {}", allowance.id.value);
    return std::move(out_);
  }

private:
  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    out_ += fmt::format(format, std::forward<Args>(args)...) + "\n";
  }

  const std::string& name(GroupId id) const { return model_.groups[id].name.value; }

  std::string names(const std::vector<GroupId>& ids) const {
    std::vector<std::string> out;
    for (const GroupId id : ids) out.push_back(name(id));
    return fmt::format("{}", fmt::join(out, ", "));
  }

  std::string names(const std::vector<Use<GroupId>>& uses) const {
    std::vector<GroupId> ids;
    for (const Use<GroupId>& use : uses) ids.push_back(use.id);
    return names(ids);
  }

  void print(const State& state) {
    std::string text = state.is_range ? fmt::format("{}..{}", state.low, state.high) : "";
    for (std::size_t i = 0; i < state.values.size(); ++i) {
      const auto value = static_cast<std::int64_t>(i);
      const bool sentinel = std::find(state.unordered.begin(), state.unordered.end(), value) != state.unordered.end();
      text += fmt::format("{}{}{}", i == 0 ? "" : " ", state.values[i], sentinel ? "(unordered)" : "");
    }
    if (state.type) text += fmt::format(", type {}", *state.type);
    text += state.initial ? fmt::format(", initial {}", state.value_text(*state.initial)) : ", unset";
    if (state.external) text += ", external";
    if (state.expires) {
      text += fmt::format(", expires after {} us to {}", state.expires->after,
                          state.expires->to ? state.value_text(*state.expires->to) : "unset");
    }
    if (state.of) text += ", of " + name(state.of->id);
    line("state {}: {}", state.name.value, text);
  }

  void print(const Group& group) {
    std::string text;
    if (group.layer) text += ", layer " + model_.layers[group.layer->id].name.value;
    if (!group.data.empty()) text += ", data " + group.data;
    if (group.realtime) text += ", realtime";
    line("group {}: module {}{}", group.name.value, model_.modules[group.module].name, text);
    print_handler("start", group.start);
    print_handler("stop", group.stop);
    for (const ProviderId provider : group.providers) print(model_.providers[provider]);
  }

  void print_handler(std::string_view which, const std::optional<Handler>& handler) {
    if (!handler) return;
    line("  {}{}", which, handler->sets.empty() ? "" : " sets " + conditions(handler->sets));
  }

  std::string conditions(const std::vector<ConditionUse>& uses) const {
    std::vector<std::string> out;
    for (const ConditionUse& use : uses) {
      out.push_back(model_.conditions[use.id].text);
      if (use.within) out.back() += fmt::format(" within {} us", *use.within);
    }
    return fmt::format("{}", fmt::join(out, ", "));
  }

  void print_conditions(std::string_view word, const std::vector<ConditionUse>& uses) {
    if (!uses.empty()) line("    {} {}", word, conditions(uses));
  }

  void print(const Provider& provider) {
    line("  provider {}", provider.name);
    print_conditions("when", provider.when);
    print_conditions("stay", provider.stay);
    print_conditions("causing", provider.causing);
    print_conditions("sets", provider.sets);
    if (!provider.needs.empty()) line("    needs {}", names(provider.needs));
    if (!provider.uses.empty()) line("    uses {}", names(provider.uses));
    for (const Use<TriggerId>& use : provider.triggers) line("    trigger {}", model_.triggers[use.id].name);
    if (provider.every) line("    every {} us", *provider.every);
    for (const Pack& pack : provider.packs) {
      std::vector<std::string> tasks;
      for (const Task& entry : pack.tasks) tasks.push_back(task(entry));
      line("    {}{}", provider.has_packs ? fmt::format("pack {}: ", pack.name) : "tasks: ", fmt::join(tasks, ", "));
    }
  }

  /// `Kick`, or `Kick(normal, urgent)` if its levels have names, which the edge lists.
  std::string task(const Task& entry) const {
    std::vector<std::string> levels;
    for (const Task::NamedLevel& level : entry.levels)
      levels.push_back(level.name.empty() ? fmt::format("level {}", level.level)
                                          : fmt::format("{} = level {}", level.name, level.level));
    return fmt::format("{} ({})", name(entry.target), fmt::join(levels, ", "));
  }

  void print(EdgeId id) {
    const Edge& edge = model_.edges[id];
    std::vector<std::string> levels;
    for (const Level& level : edge.levels)
      levels.push_back(
          fmt::format("{}{}{}", level.priority, level.optional ? " optional" : "", level.apart ? " apart" : ""));
    line("edge {}: {}{}", model_.edge_name(id),
         levels.empty() ? "never requested" : fmt::format("{}", fmt::join(levels, ", ")),
         edge.needed ? ", needed" : "");
  }

  void print(const Assertion& assertion) {
    switch (assertion.kind) {
    case Assertion::Kind::never_together: return line("assert never together {}", names(assertion.groups));
    case Assertion::Kind::beats: return line("assert beats {}", names(assertion.groups));
    case Assertion::Kind::can_run: return line("assert can run {}", names(assertion.groups));
    case Assertion::Kind::soft: return line("assert soft {}", names(assertion.groups));
    }
  }

  const Model& model_;
  std::string out_;
};

} // namespace

std::string print_model(const Model& model) { return Printer(model).run(); }

} // namespace director::compiler
