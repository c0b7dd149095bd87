// SPDX-License-Identifier: MIT
// On random behaviours, explored completely, in which a task waits for something that depends on the task itself:
// conditions that a finding calls lost for good never come back once they are lost together. And mostly they are lost
// together at some time, so that the finding is useful.
//
//   DIRECTOR_SEED   first seed, instead of 1
//   DIRECTOR_CASES  how many behaviours with such a finding
//   DIRECTOR_LONG   set: more of them
//   DIRECTOR_SHOW   set: each behaviour whose conditions are never lost together
#include "compiler/pipeline.hpp"
#include "dsl/source/render.hpp"
#include "tests/property/small_behaviour.hpp"
#include "tests/property/verdicts.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace {

using namespace director;
using namespace director::property;

/// A small behaviour in which the first root waits for what another group causes, while a state has the value that the
/// first one sets, or a lower one; and a third group may undo it. The rest is random, and may bring it back.
BehaviourDraft looped(std::uint64_t seed) {
  BehaviourDraft draft = small_behaviour(seed);
  Random r(seed + 80'000'000);
  while (draft.states.size() < 2) {
    draft.states.push_back(
        {"More" + std::to_string(draft.states.size()), {"v0", "v1"}, false, false, 0, false, {}, {}, {}});
  }
  for (StateDraft& state : draft.states) {
    if (!state.initial) state.initial = 0;
    if (r.chance(0.9)) state.external = false, state.expires = state.expires_to = std::nullopt;
    if (r.chance(0.8)) state.owner = std::nullopt;
  }
  const auto is = [&](std::size_t state, bool initial) {
    const std::size_t at = *draft.states[state].initial;
    return ConditionDraft{state, "==", {initial ? at : (at + 1) % draft.states[state].values.size()}, {}};
  };
  const std::size_t task = draft.roots.front().target;
  std::vector<std::size_t> others;
  for (std::size_t g = 0; g < draft.groups.size(); ++g) {
    if (g != task) others.push_back(g);
  }
  const std::size_t causer = r.one_of(others), spoiler = r.one_of(others);
  const std::vector<std::size_t> states = r.some<std::size_t>({0, 1}, 2, 2);
  const ConditionDraft goal = is(states[0], r.chance(0.7)), guard = is(states[1], r.chance(0.3));
  for (ProviderDraft& each : draft.groups[task].providers) {
    if (r.chance(0.9)) each.when = {goal};
    if (r.chance(0.9)) each.stay.clear();
    if (r.chance(0.5)) each.sets = {guard};
  }
  ProviderDraft& causing = draft.groups[causer].providers.back();
  causing.causing = {goal};
  if (r.chance(0.7)) causing.when = {guard};
  ConditionDraft undone = goal;
  undone.values = {(goal.values.front() + 1) % draft.states[states[0]].values.size()};
  draft.groups[spoiler].providers.front().sets = {undone};
  for (GroupDraft& group : draft.groups) {
    if (r.chance(0.8)) group.stop_sets.clear();
  }
  return draft;
}

struct Losses {
  std::size_t tried = 0, findings = 0, lost = 0;
  std::vector<std::string> wrong;
};

void find_losses(Losses& seen, std::uint64_t seed) {
  ++seen.tried;
  const std::string text = to_yaml(to_document(looped(seed)));
  dsl::MemoryFiles files;
  files.add("looped.yaml", text);
  dsl::Sources sources;
  const compiler::Checked checked = compiler::check("looped.yaml", files, sources);
  // Checks take what errors report as corrected, and so as happening.
  if (!checked.lowerable || dsl::has_errors(checked.findings)) return;
  std::vector<NeverBack> claims;
  for (const dsl::Diagnostic& finding : checked.findings) {
    for (const Claim& claim : claims_of(finding, checked.model)) {
      if (const auto* back = std::get_if<NeverBack>(&claim)) claims.push_back(*back);
    }
  }
  if (claims.empty()) return;
  const compiler::Ground ground(checked.model);
  Reached reached(ground);
  if (!reached.find_changes(20'000)) return; // it has more states
  for (const NeverBack& claim : claims) {
    ++seen.findings;
    const bool is_lost = std::any_of(reached.changes.begin(), reached.changes.end(),
                                     [&](const auto& change) { return are_lost(claim, checked.model, change.second); });
    if (is_lost) ++seen.lost;
    if (is_contradicted(claim, checked.model, reached))
      seen.wrong.push_back("seed " + std::to_string(seed) + ": " + in_words(claim, checked.model) + "\n" + text);
    if (!is_lost && std::getenv("DIRECTOR_SHOW") != nullptr)
      std::cout << "seed " << seed << ", never lost\n" << text << dsl::render(checked.findings, sources);
  }
}

TEST_CASE("conditions that a finding calls lost for good never come back, and mostly are lost") {
  const auto first = tests::from_environment<std::uint64_t>("DIRECTOR_SEED", 1);
  const std::uint64_t cases = tests::cases_of({.usual = 40, .slow = 8, .whole = 1'000});
  Losses seen;
  for (std::uint64_t seed = first; seen.findings < cases && seed < first + 100 * cases; ++seed) find_losses(seen, seed);
  std::cout << seen.tried << " behaviours, " << seen.findings << " findings, of which " << seen.lost
            << " were seen lost\n";
  for (const std::string& each : seen.wrong) UNSCOPED_INFO(each);
  CHECK(seen.wrong.empty());
  CHECK(seen.findings >= cases);
  CHECK(seen.lost * 10 >= seen.findings * 9);
}

} // namespace
