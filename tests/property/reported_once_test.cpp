// SPDX-License-Identifier: MIT
// On random behaviours: only one finding reports that a task never runs for a requester, and where one does, no other
// finding reports that something else needs the same group. Behaviours are checked, not explored.
//
//   DIRECTOR_SEED   first seed, instead of 1
//   DIRECTOR_CASES  how many behaviours
//   DIRECTOR_LONG   set: more of them
#include "compiler/pipeline.hpp"
#include "tests/property/small_behaviour.hpp"
#include "tests/property/verdicts.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <set>

namespace {

using namespace director;
using namespace director::property;

/// Checks that report that a task never runs for its requester, each for another reason.
const std::set<std::string> speak_of_tasks{"optional_never_runs", "self_conflict", "sibling_starvation",
                                           "starved_task",        "task_cycle",    "uncovered_state"};

/// What is reported twice, each in a line.
std::string find_told_twice(std::uint64_t seed) {
  dsl::MemoryFiles files;
  const std::string text = to_yaml(to_document(small_behaviour(seed)));
  files.add("small.yaml", text);
  dsl::Sources sources;
  const compiler::Checked checked = compiler::check("small.yaml", files, sources);
  if (!checked.lowerable) return {};
  std::map<compiler::EdgeId, std::vector<std::string>> never, wanted;
  for (const dsl::Diagnostic& finding : checked.findings) {
    if (speak_of_tasks.count(finding.id) == 0) continue;
    bool says_never = false;
    for (const Claim& claim : claims_of(finding, checked.model)) {
      const auto* granted = std::get_if<NeverGranted>(&claim);
      if (granted == nullptr) continue;
      never[granted->edge].push_back(finding.id + ": " + finding.message);
      says_never = true;
    }
    if (says_never || finding.id == "task_cycle") continue; // of a cycle, either request may be reported
    for (const compiler::EdgeId loser : losers_of(finding, checked.model))
      wanted[loser].push_back(finding.id + ": " + finding.message);
  }
  std::string out;
  for (auto& [edge, reported] : never) {
    reported.insert(reported.end(), wanted[edge].begin(), wanted[edge].end());
    if (reported.size() < 2) continue;
    out += "seed " + std::to_string(seed) + ", " + checked.model.edge_name(edge) + ":\n";
    for (const std::string& each : reported) out += "  " + each + "\n";
  }
  return out.empty() ? out : out + text;
}

TEST_CASE("only one finding reports that a task never runs for a requester") {
  const auto first = tests::from_environment<std::uint64_t>("DIRECTOR_SEED", 1);
  const std::uint64_t cases = tests::cases_of({.usual = 800, .slow = 8, .whole = 3'000});
  std::string twice;
  for (std::uint64_t seed = first; seed < first + cases; ++seed) twice += find_told_twice(seed);
  CHECK(twice == "");
}

} // namespace
