// Header: tests/property/generate.hpp. Test: tests/property/generate_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/generate.hpp"

namespace director::property {

namespace {

/// The groups of the behaviour.
enum Part : std::size_t { first, middle, wanted, needy, scarce, count };

TaskDraft task(std::size_t target, int priority = 0, bool apart = false) {
  return {target, {{"", priority, false, apart}}};
}

ProviderDraft provider(const char* name, std::vector<std::size_t> needs, std::vector<TaskDraft> tasks) {
  ProviderDraft out;
  out.name = name;
  out.needs = std::move(needs);
  if (!tasks.empty()) out.packs = {{"", std::move(tasks)}};
  return out;
}

/// `scarce` and `wanted` may be denied to those below `first`, because equals hold them. `first` tries `scarce` before,
/// but has another choice.
BehaviourDraft equals(Random& random) {
  BehaviourDraft out;
  StateDraft& state = out.states.emplace_back();
  state.name = "S0";
  state.values = {"v0", "v1", "v2"};
  const auto when = [&] { return std::vector<ConditionDraft>{{0, "!=", {random.below(3)}, {}}}; };
  out.groups.resize(count);
  for (std::size_t g = 0; g < count; ++g) out.groups[g].name = "G" + std::to_string(g);
  out.groups[first].providers = {
      provider("p0", {},
               random.some<TaskDraft>({task(scarce, random.one_of({0, 10, 10})), task(wanted), task(middle),
                                       task(needy, 0, random.chance(0.8))},
                                      4, 4)),
      provider("p1", {needy}, {task(needy)})};
  out.groups[middle].providers = {provider("default", {}, {task(wanted)})};
  out.groups[wanted].providers = {provider("p0", {scarce}, {}), provider("p1", {}, {})};
  out.groups[needy].providers = {provider("default", {scarce}, {})};
  out.groups[scarce].providers = {provider("default", {}, {})};
  out.groups[first].providers[0].when = when();
  out.groups[wanted].providers[1].when = when();
  for (const std::size_t g : {first, middle, wanted}) out.roots.push_back(task(g));
  return out;
}

Node setting(Random& random, const BehaviourDraft& behaviour) {
  Node out;
  out.add("set", {}).add("S0", random.one_of(behaviour.states[0].values));
  return out;
}

Node one_root(Random& random, const BehaviourDraft& behaviour, const char* what) {
  Node out;
  out.add(what, behaviour.groups[random.one_of(behaviour.roots).target].name);
  return out;
}

Node step(Random& random, const BehaviourDraft& behaviour) {
  Node inputs = Node::list();
  for (int i = random.between(1, 3); i > 0; --i) {
    const std::size_t kind = random.below(10);
    inputs.add(kind < 5   ? setting(random, behaviour)
               : kind < 9 ? one_root(random, behaviour, "request")
                          : one_root(random, behaviour, "cancel"));
  }
  Node out;
  out.add("inputs", inputs);
  return out;
}

} // namespace

Documents generate_equals(std::uint64_t seed) {
  Random random(seed + 90'000'000);
  const BehaviourDraft behaviour = equals(random);
  Node scenario;
  scenario.add("scenario", "random");
  scenario.add("behaviour", "behaviour.yaml");
  Node& steps = scenario.add("steps", Node::list());
  for (int i = random.between(10, 30); i > 0; --i) steps.add(step(random, behaviour));
  return {to_document(behaviour), scenario};
}

} // namespace director::property
