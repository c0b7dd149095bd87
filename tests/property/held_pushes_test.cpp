// SPDX-License-Identifier: MIT
// On random behaviours, explored completely, in which a task waits for a state that could be pushed for, and an earlier
// choice for something outside: if push_held_by_outside says that nothing is pushed while the outside condition is
// false, then there is a state in which the later choice lacks only the awaited condition, and nothing is pushed. And
// without the earlier providers it is.
//
//   DIRECTOR_SEED   first seed, instead of 1
//   DIRECTOR_CASES  how many behaviours with such a finding
//   DIRECTOR_LONG   set: more of them
//   DIRECTOR_SHOW   set: each behaviour that contradicts its finding
#include "compiler/explore/search/search.hpp"
#include "compiler/pipeline.hpp"
#include "dsl/source/render.hpp"
#include "tests/property/draft.hpp"
#include "tests/property/random.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace director;
using namespace director::property;

constexpr std::size_t pose = 0, outside = 1;

LevelDraft rank(int priority, bool apart = false) {
  LevelDraft out;
  out.priority = priority;
  out.apart = apart;
  return out;
}

std::vector<ConditionDraft> some_conditions(Random& r) {
  std::vector<ConditionDraft> out;
  if (r.chance(0.3)) out.push_back({pose, "==", {1}, {}});
  if (r.chance(0.6)) out.push_back({outside, "==", {r.below(3)}, {}});
  return out;
}

/// Two or three providers that depend on the outside, on the pose, or on both.
std::vector<ProviderDraft> held_ways(Random& r, bool needs) {
  std::vector<ProviderDraft> out;
  const std::size_t count = 2 + r.below(2);
  for (std::size_t i = 0; i < count; ++i) {
    ProviderDraft way;
    way.name = "w" + std::to_string(i);
    way.when = some_conditions(r);
    if (needs && r.chance(0.4)) way.needs = {4};
    out.push_back(std::move(way));
  }
  return out;
}

/// G1 waits, by itself, with what it needs (G3), or together with G3; G2 causes the pose, and goes after it.
BehaviourDraft draft_held(std::uint64_t seed) {
  Random r(seed + 80'000'000);
  BehaviourDraft draft;
  StateDraft state;
  state.name = "S";
  state.values = {"v0", "v1"};
  state.initial = r.below(2);
  state.external = r.chance(0.1);
  draft.states.push_back(state);
  state.name = "O";
  state.values = {"o0", "o1", "o2"};
  state.initial = r.below(3);
  state.external = true;
  draft.states.push_back(state);
  draft.groups.resize(5);
  for (std::size_t g = 0; g < draft.groups.size(); ++g) {
    draft.groups[g].name = "G" + std::to_string(g);
    ProviderDraft rest;
    rest.name = "default";
    draft.groups[g].providers = {rest};
  }
  const std::size_t shape = r.below(3);
  ProviderDraft& waits = draft.groups[1].providers.front();
  if (shape == 0) {
    draft.groups[1].providers = held_ways(r, true);
  } else {
    waits.when = {{pose, "==", {1}, {}}};
    draft.groups[3].providers = held_ways(r, true);
    if (shape == 1) waits.needs = {3};
  }
  PackDraft pack{"whole", {{1, {rank(0)}}}};
  if (shape == 2) pack.tasks.push_back({3, {rank(0)}});
  if (r.chance(0.2)) pack.tasks.push_back({4, {rank(0, r.chance(0.5))}});
  draft.groups[0].providers.front().packs = {std::move(pack)};
  ProviderDraft walking, halting;
  walking.name = "p0", halting.name = "p1";
  walking.sets = {{pose, "==", {0}, {}}};
  if (r.chance(0.2)) walking.when = {{outside, "==", {r.below(3)}, {}}};
  halting.causing = {{pose, "==", {1}, {}}};
  draft.groups[2].providers = {walking, halting};
  draft.roots = {{0, {rank(20)}}, {2, {rank(10)}}};
  return draft;
}

struct HeldClaim {
  compiler::ConditionId outside{}, wanted{};
  compiler::GroupId task{}, pushed{};
  compiler::ProviderId later{};
};

std::vector<std::string> quoted_words(const std::string& message) {
  std::vector<std::string> out;
  for (std::size_t at = message.find('`'); at != std::string::npos; at = message.find('`', at + 1)) {
    const std::size_t end = message.find('`', at + 1);
    out.push_back(message.substr(at + 1, end - at - 1));
    at = end;
  }
  return out;
}

/// "while `O == o0` is false, `G1` does not push `G2.p1` for `S == v1`: `G3.w0` comes first …, and `G3.w1` is not
/// tried"
std::optional<HeldClaim> claim_of(const dsl::Diagnostic& finding, const compiler::Model& model) {
  if (finding.id != "push_held_by_outside") return std::nullopt;
  const std::vector<std::string> names = quoted_words(finding.message);
  REQUIRE(names.size() == 6);
  HeldClaim out;
  for (const compiler::ConditionId id : model.conditions.ids()) {
    if (model.conditions[id].text == names[0]) out.outside = id;
    if (model.conditions[id].text == names[3]) out.wanted = id;
  }
  for (const compiler::GroupId id : model.groups.ids()) {
    if (model.groups[id].name.value == names[1]) out.task = id;
  }
  for (const compiler::ProviderId id : model.providers.ids()) {
    if (model.full_name(id) == names[2]) out.pushed = model.providers[id].group;
    if (model.full_name(id) == names[5]) out.later = id;
  }
  return out;
}

bool holds_now(const compiler::Model& model, const Engine& engine, compiler::ConditionId id) {
  const std::int32_t value = engine.value(model.conditions[id].state.value);
  return value != unset && model.conditions[id].accepts.contains(value);
}

bool is_queued(const compiler::Model& model, const Engine& engine, compiler::GroupId task) {
  const auto& requesters = model.groups[task].requesters;
  return std::any_of(requesters.begin(), requesters.end(), [&](compiler::EdgeId edge) {
    return !model.edges[edge].levels.empty() && engine.state(edge.value) == RunState::queued;
  });
}

/// The task waits, what could be pushed for it runs, and the later provider lacks at most the awaited condition.
bool is_held(const HeldClaim& claim, const compiler::Model& model, const compiler::Machine& machine) {
  const Engine& engine = machine.engine();
  const auto& when = model.providers[claim.later].when;
  return machine.phase() == compiler::Phase::rest && is_queued(model, engine, claim.task) &&
         !holds_now(model, engine, claim.outside) && !holds_now(model, engine, claim.wanted) &&
         std::all_of(when.begin(), when.end(),
                     [&](const auto& use) { return use.id == claim.wanted || holds_now(model, engine, use.id); }) &&
         engine.granted(claim.pushed.value) && engine.memory().last[claim.pushed.value].push.edge == nil;
}

struct Drafted {
  compiler::Checked checked;
  std::string text, findings;
};

Drafted check_draft(const BehaviourDraft& draft) {
  Drafted out;
  out.text = to_yaml(to_document(draft));
  dsl::MemoryFiles files;
  files.add("held.yaml", out.text);
  dsl::Sources sources;
  out.checked = compiler::check("held.yaml", files, sources);
  out.findings = dsl::render(out.checked.findings, sources);
  return out;
}

/// Whether some state of all is so; nothing: there are too many.
template <class Is>
std::optional<bool> any_state(const compiler::Model& model, const Is& is) {
  const compiler::Ground ground(model);
  bool out = false;
  compiler::SearchOptions how;
  how.bound = 20'000;
  how.threads = 1;
  how.look = [&](const compiler::Machine& machine) { out = out || is(machine); };
  if (!compiler::search(ground, how).complete) return std::nullopt;
  return out;
}

/// The same behaviour without the providers before this one.
BehaviourDraft without_earlier(BehaviourDraft draft, const compiler::Model& model, compiler::ProviderId later) {
  for (GroupDraft& group : draft.groups) {
    if (group.name != model.group_of(later).name.value) continue;
    const auto at = std::find_if(group.providers.begin(), group.providers.end(), [&](const ProviderDraft& provider) {
      return group.name + "." + provider.name == model.full_name(later);
    });
    group.providers.erase(group.providers.begin(), at);
  }
  return draft;
}

struct HeldCounts {
  std::size_t tried = 0, findings = 0, held = 0, pushed = 0;
};

void look_at_held(HeldCounts& counts, std::uint64_t seed) {
  ++counts.tried;
  const BehaviourDraft draft = draft_held(seed);
  const Drafted seen = check_draft(draft);
  if (!seen.checked.lowerable) return;
  const compiler::Model& model = seen.checked.model;
  for (const dsl::Diagnostic& finding : seen.checked.findings) {
    const auto claim = claim_of(finding, model);
    if (!claim) continue;
    const auto is_seen = any_state(model, [&](const auto& machine) { return is_held(*claim, model, machine); });
    if (!is_seen) continue;
    const Drafted other = check_draft(without_earlier(draft, model, claim->later));
    REQUIRE(other.checked.lowerable);
    const auto is_pushed = any_state(other.checked.model, [&](const compiler::Machine& machine) {
      return machine.engine().memory().last[claim->pushed.value].push.edge != nil;
    });
    ++counts.findings;
    if (*is_seen) ++counts.held;
    if (is_pushed == true) ++counts.pushed;
    if ((!*is_seen || is_pushed != true) && std::getenv("DIRECTOR_SHOW") != nullptr)
      std::cout << "seed " << seed << (*is_seen ? ", not pushed without\n" : ", never held\n") << seen.text
                << seen.findings;
  }
}

TEST_CASE("while something outside is lacking nothing is pushed, and without the earlier provider it is") {
  const auto first = tests::from_environment<std::uint64_t>("DIRECTOR_SEED", 1);
  const std::uint64_t cases = tests::cases_of({.usual = 150, .slow = 8, .whole = 2'000});
  HeldCounts counts;
  for (std::uint64_t seed = first; counts.findings < cases && seed < first + 100 * cases; ++seed)
    look_at_held(counts, seed);
  std::cout << counts.tried << " behaviours, " << counts.findings << " findings: " << counts.held
            << " were seen to hold a push, " << counts.pushed << " pushed without the earlier provider\n";
  CHECK(counts.findings >= cases);
  CHECK(counts.held == counts.findings);
  CHECK(counts.pushed == counts.findings);
}

} // namespace
