// SPDX-License-Identifier: MIT
// On random behaviours, explored completely, in which packs rank a waiting task before or behind one that could help
// it: if causer_goes_first says that a task may wait, it does wait there in some state, without a push, while the other
// one runs.
//
//   DIRECTOR_SEED   first seed, instead of 1
//   DIRECTOR_CASES  how many behaviours with such a finding
//   DIRECTOR_LONG   set: more of them
//   DIRECTOR_SHOW   set: each behaviour in which it is never seen to wait
#include "compiler/explore/search/search.hpp"
#include "compiler/pipeline.hpp"
#include "dsl/source/render.hpp"
#include "tests/property/draft.hpp"
#include "tests/property/random.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <iostream>
#include <optional>

namespace {

using namespace director;
using namespace director::property;

LevelDraft level(Random& r, double apart) {
  LevelDraft out;
  out.priority = r.one_of({0, 5, 5, 10});
  out.optional = r.chance(0.1);
  out.apart = !out.optional && r.chance(apart);
  return out;
}

/// G0 requests G1, which waits, perhaps through G3, and G2, which could help it.
BehaviourDraft ranked(std::uint64_t seed) {
  Random r(seed + 60'000'000);
  BehaviourDraft draft;
  StateDraft state;
  state.name = "S";
  state.values = {"v0", "v1"};
  state.initial = r.below(2);
  state.external = r.chance(0.1);
  draft.states = {state};
  draft.groups.resize(4);
  for (std::size_t g = 0; g < 4; ++g) draft.groups[g].name = "G" + std::to_string(g);
  const bool deep = r.chance(0.4);
  ProviderDraft play;
  play.name = "default";
  for (const char* const name : {"one", "two"}) {
    PackDraft pack{name, {{deep ? 3U : 1U, {level(r, 0.2)}}, {2, {level(r, 0.8)}}}};
    if (!deep && r.chance(0.3)) pack.tasks.push_back({3, {level(r, 0.5)}});
    play.packs.push_back(std::move(pack));
  }
  draft.groups[0].providers = {play};
  ProviderDraft kick;
  kick.name = "default";
  kick.when = {{0, "==", {1}, {}}};
  if (r.chance(0.2)) kick.needs = {3};
  if (deep) kick.needs.clear();
  draft.groups[1].providers = {kick};
  ProviderDraft walking, halting, rest;
  walking.name = "p0", halting.name = "p1", rest.name = "default";
  if (r.chance(0.8)) walking.sets = {{0, "==", {0}, {}}};
  if (r.chance(0.1)) walking.when = {{0, "==", {1}, {}}};
  halting.causing = {{0, "==", {1}, {}}};
  draft.groups[2].providers = {walking, halting};
  if (deep) rest.packs = {{"whole", {{1, {level(r, 0.2)}}}}};
  if (!deep && r.chance(0.2)) rest.packs = {{"whole", {{2, {level(r, 0.5)}}}}};
  draft.groups[3].providers = {rest};
  draft.roots = {{0, {LevelDraft{}}}};
  return draft;
}

struct Waits {
  compiler::EdgeId edge{};
  compiler::GroupId pushed{};
  compiler::ConditionId condition{};
};

/// "`Kick` may wait here for `Pose == standing`, and pushes nobody for it: `Walk` does not rank after `Kick`"
std::optional<Waits> waits_in(const dsl::Diagnostic& finding, const compiler::Model& model) {
  if (finding.id != "causer_goes_first") return std::nullopt;
  std::optional<Waits> out;
  for (const compiler::Provider& provider : model.providers) {
    for (const compiler::Pack& pack : provider.packs) {
      for (const compiler::Task& task : pack.tasks) {
        if (task.span == finding.span) out = Waits{task.edge, {}, {}};
      }
    }
  }
  if (!out) return out;
  for (const compiler::ConditionId id : model.conditions.ids()) {
    if (finding.message.find("`" + model.conditions[id].text + "`") != std::string::npos) out->condition = id;
  }
  for (const compiler::Provider& provider : model.providers) {
    if (!provider.causing.empty()) out->pushed = provider.group;
  }
  return out;
}

bool is_waiting(const Waits& waits, const compiler::Model& model, const compiler::Machine& machine) {
  const Engine& engine = machine.engine();
  const compiler::Condition& condition = model.conditions[waits.condition];
  const std::int32_t value = engine.value(condition.state.value);
  return machine.phase() == compiler::Phase::rest && engine.state(waits.edge.value) == RunState::queued &&
         engine.granted(waits.pushed.value) && (value == unset || !condition.accepts.contains(value)) &&
         engine.memory().last[waits.pushed.value].push.edge == nil;
}

struct Waiting {
  std::size_t tried = 0, findings = 0, waits = 0;
};

void find_waiting(Waiting& seen, std::uint64_t seed) {
  ++seen.tried;
  const std::string text = to_yaml(to_document(ranked(seed)));
  dsl::MemoryFiles files;
  files.add("ranked.yaml", text);
  dsl::Sources sources;
  const compiler::Checked checked = compiler::check("ranked.yaml", files, sources);
  if (!checked.lowerable) return;
  for (const dsl::Diagnostic& finding : checked.findings) {
    const std::optional<Waits> waits = waits_in(finding, checked.model);
    if (!waits) continue;
    const compiler::Ground ground(checked.model);
    bool is_seen = false;
    compiler::SearchOptions how;
    how.bound = 20'000; // a behaviour with more states is left out
    how.threads = 1;
    how.look = [&](const compiler::Machine& machine) {
      is_seen = is_seen || is_waiting(*waits, checked.model, machine);
    };
    if (!compiler::search(ground, how).complete) continue;
    ++seen.findings;
    if (is_seen) ++seen.waits;
    if (!is_seen && std::getenv("DIRECTOR_SHOW") != nullptr)
      std::cout << "seed " << seed << ", never waits\n" << text << dsl::render(checked.findings, sources);
  }
}

TEST_CASE("a task that may wait behind a provider that could help it does wait in an exploration") {
  const auto first = tests::from_environment<std::uint64_t>("DIRECTOR_SEED", 1);
  const std::uint64_t cases = tests::cases_of({.usual = 150, .slow = 8, .whole = 2'000});
  Waiting seen;
  for (std::uint64_t seed = first; seen.findings < cases && seed < first + 100 * cases; ++seed)
    find_waiting(seen, seed);
  std::cout << seen.tried << " behaviours, " << seen.findings << " findings, of which " << seen.waits
            << " were seen to wait\n";
  CHECK(seen.findings >= cases);
  CHECK(seen.waits == seen.findings);
}

} // namespace
