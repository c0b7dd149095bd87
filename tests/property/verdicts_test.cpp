// SPDX-License-Identifier: MIT
// The quality of findings: random small behaviours are explored completely, and compared with the findings of the
// checks. No finding says never of what was reached; and nearly all that was never reached (a provider, a task, a pack
// as a whole or a push) is reported, by a finding about it or about what it depends on.
//
// Bodies that leave out optional entries of a pack are explored too, which exploration otherwise keeps: what happens
// only with them is not impossible.
//
// What counts as never reached, and as reported:
// - A provider that never ran, a task (an edge with a level) that was never granted, a named pack whose mandatory
//   members, two or more, were never granted together, and a promise that was never pushed for a condition of another
//   group. A promise that is pushed for one condition does not count for the others that it serves.
// - It is reported by a finding about it, at any level, also a lint; or by what it depends on: something else that was
//   never reached, without which it could not happen, if all alternatives to that are reported too (unreached.cpp has
//   these ways). A cycle of such is reported only if it has a finding.
// - The checks take what is reported as impossible by declarations alone as corrected, and do not report what follows.
//   That depends on the reported fault if the same analysis, with the fault as it is, proves that it never happens
//   (follow_on.cpp).
//
//   DIRECTOR_SEED   first seed, instead of 1
//   DIRECTOR_CASES  how many behaviours, instead of as many as take half a minute
//   DIRECTOR_LONG   set: 4,000 behaviours, and without a first seed 300 more in each of four ranges far away
//   DIRECTOR_SHOW   set: each contradiction and each silence, with its seed; to a seed: its behaviour; to an id or a
//                   kind of silence: the smallest behaviours that show the same
#include "compiler/pipeline.hpp"
#include "dsl/source/render.hpp"
#include "tests/property/shrink.hpp"
#include "tests/property/small_behaviour.hpp"
#include "tests/property/verdicts.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>

#include <iomanip>
#include <iostream>
#include <map>
#include <optional>
#include <set>

namespace {

using namespace director;
using namespace director::property;
using tests::from_environment;
using tests::is_long;

constexpr tests::Series small_behaviours{.usual = 400, .slow = 20, .whole = 4'000};
constexpr double least_reported = tests::is_slow ? 98 : 99.3; ///< percent of what was never reached; one of few matters
constexpr std::size_t bound = 30'000;                         ///< states of one behaviour; one with more is left out
constexpr double least_reported_long = 99.1;
constexpr std::uint64_t far_ranges[] = {70'001, 100'001, 200'001, 300'001};
constexpr std::uint64_t far_cases = 300;
constexpr double least_reported_far = 99; ///< of some 2,300 each
/// Checks that say never of what was reached; no other may. task_cycle reports the request that closes a cycle from
/// where the cycle is entered; from another place another request closes it. That is tolerated: the finding is an
/// error, whichever request it names, and disappears with the cycle.
const std::set<std::string> wrong_ids{};

struct Count {
  std::size_t right = 0, wrong = 0;
  std::uint64_t seed = 0; ///< of the first that was wrong
  void add(bool is_right, std::uint64_t at) {
    if (!is_right && wrong++ == 0) seed = at;
    if (is_right) ++right;
  }
};

struct Measure {
  std::size_t tried = 0, explored = 0, states = 0;
  std::map<std::string, Count> findings; ///< by id: confirmed, contradicted
  std::map<std::string, Count> silences; ///< by kind of what was never reached: reported, not reported
  std::vector<std::string> contradictions;

  Count all(const std::map<std::string, Count>& counts) const {
    Count out;
    for (const auto& [name, count] : counts) out.right += count.right, out.wrong += count.wrong;
    return out;
  }
  double share() const {
    const Count count = all(silences);
    return 100.0 * static_cast<double>(count.right) / static_cast<double>(count.right + count.wrong);
  }
};

/// One behaviour, explored; nothing if it cannot be run or has too many states.
struct Judged {
  std::size_t states = 0;
  struct Finding {
    std::string id, message, wrong; ///< wrong: what it claims although it was reached
  };
  std::vector<Finding> claiming; ///< those that claim something
  std::vector<Unreached> unreached;
  std::string findings; ///< as they are printed
};

std::optional<Judged> judge(const std::string& text) {
  dsl::MemoryFiles files;
  files.add("small.yaml", text);
  dsl::Sources sources;
  compiler::CheckOptions options;
  options.selection.every_lint = true;
  const compiler::Checked checked = compiler::check("small.yaml", files, sources, options);
  if (!checked.lowerable) return std::nullopt;
  const compiler::Model& model = checked.model;
  const compiler::Ground ground(model);
  Reached reached(ground);
  compiler::SearchOptions how;
  how.bound = bound;
  how.threads = 1;
  how.look = [&](const compiler::Machine& machine) { reached.look(machine); };
  const compiler::Searched searched = compiler::search(ground, how);
  if (!reached.take(searched)) return std::nullopt;
  Judged out;
  out.states = searched.states;
  for (const dsl::Diagnostic& finding : checked.findings) {
    const std::vector<Claim> claims = claims_of(finding, model);
    if (claims.empty()) continue;
    if (std::holds_alternative<NeverBack>(claims.front()) && reached.changes.empty()) reached.find_changes(bound);
    Judged::Finding& row = out.claiming.emplace_back(Judged::Finding{finding.id, finding.message, ""});
    for (const Claim& claim : claims) {
      if (is_contradicted(claim, model, reached)) row.wrong = in_words(claim, model);
    }
  }
  for (const compiler::ProviderId id : follow_on_of(model).idle) {
    const Claim claim = NeverRuns{id};
    const bool is_wrong = is_contradicted(claim, model, reached);
    out.claiming.push_back({"a reported fault", "as it is", is_wrong ? in_words(claim, model) : ""});
  }
  out.unreached = unreached_of(model, reached, checked.findings);
  out.findings = dsl::render(checked.findings, sources);
  return out;
}

/// Whether it has a finding with this id that says never of what was reached, or no finding for something of this kind.
bool shows(const Judged& judged, std::string_view kind) {
  return std::any_of(judged.claiming.begin(), judged.claiming.end(),
                     [&](const Judged::Finding& each) { return !each.wrong.empty() && each.id == kind; }) ||
         std::any_of(judged.unreached.begin(), judged.unreached.end(),
                     [&](const Unreached& each) { return !each.reported && each.kind == kind; });
}

/// The smallest behaviour found that shows the same.
void print_small(std::uint64_t seed, const std::string& kind) {
  Documents documents{to_document(small_behaviour(seed)), {}};
  documents.scenario.add("steps", Node::list({"none"}));
  const Documents small = shrink(documents, [&](const Documents& candidate) {
    const std::optional<Judged> judged = judge(to_yaml(candidate.behaviour));
    return judged && shows(*judged, kind);
  });
  const std::string text = to_yaml(small.behaviour, 3);
  const std::optional<Judged> judged = judge(text);
  std::cout << "seed " << seed << ": " << kind << "\n" << text;
  if (!judged) return;
  for (const Judged::Finding& each : judged->claiming) {
    if (!each.wrong.empty()) std::cout << "reached although " << each.wrong << "\n";
  }
  for (const Unreached& each : judged->unreached) {
    if (!each.reported) std::cout << "silent of " << each.what << ", " << each.kind << "\n";
  }
  std::cout << judged->findings << "\n";
}

void take(Measure& measure, std::uint64_t seed) {
  ++measure.tried;
  const std::string text = to_yaml(to_document(small_behaviour(seed)));
  const std::optional<Judged> judged = judge(text);
  if (!judged) return;
  ++measure.explored;
  measure.states += judged->states;
  const char* const show = std::getenv("DIRECTOR_SHOW");
  for (const Judged::Finding& each : judged->claiming) {
    measure.findings[each.id].add(each.wrong.empty(), seed);
    if (each.wrong.empty()) continue;
    const std::string line =
        "seed " + std::to_string(seed) + ": " + each.id + ": " + each.message + " (" + each.wrong + ")";
    if (show != nullptr) std::cout << line << "\n";
    if (!wrong_ids.contains(each.id)) measure.contradictions.push_back(line);
  }
  for (const Unreached& each : judged->unreached) {
    measure.silences[each.kind].add(each.reported, seed);
    if (show != nullptr && !each.reported)
      std::cout << "seed " << seed << ": silent of " << each.what << ", " << each.kind << "\n";
  }
  if (show != nullptr && shows(*judged, show)) print_small(seed, show);
  if (show != nullptr && show == std::to_string(seed)) std::cout << text << judged->findings;
}

void print(const Measure& measure) {
  std::cout << measure.tried << " behaviours, " << measure.explored << " explored whole, " << measure.states
            << " states\nFindings that say never: confirmed, contradicted\n";
  for (const auto& [id, count] : measure.findings) {
    std::cout << std::setw(8) << count.right << std::setw(8) << count.wrong << "  " << id;
    if (count.wrong > 0) std::cout << " (first: seed " << count.seed << ")";
    std::cout << "\n";
  }
  const Count all = measure.all(measure.silences);
  std::cout << "Never reached: reported, not reported\n";
  for (const auto& [kind, count] : measure.silences) {
    std::cout << std::setw(8) << count.right << std::setw(8) << count.wrong << "  " << kind;
    if (count.wrong > 0) std::cout << " (first: seed " << count.seed << ")";
    std::cout << "\n";
  }
  std::cout << std::fixed << std::setprecision(2) << measure.share() << " % of " << all.right + all.wrong
            << " that were never reached are reported\n";
}

void take_range(Measure& measure, std::uint64_t first, std::uint64_t cases) {
  const std::size_t before = measure.explored;
  for (std::uint64_t seed = first; measure.explored < before + cases && seed < first + 10 * cases; ++seed)
    take(measure, seed);
}

TEST_CASE("what findings call impossible is never reached, and what is never reached is reported") {
  const std::uint64_t first = from_environment<std::uint64_t>("DIRECTOR_SEED", 1);
  const std::uint64_t cases = tests::cases_of(small_behaviours);
  Measure measure;
  take_range(measure, first, cases);
  print(measure);
  for (const std::string& each : measure.contradictions) UNSCOPED_INFO(each);
  CHECK(measure.contradictions.empty());
  CHECK(measure.explored == cases);
  CHECK(measure.share() >= (is_long() ? least_reported_long : least_reported));
}

TEST_CASE("findings are true for behaviours for which one was once false") {
  if (tests::is_sanitized) return; // findings are the same with sanitizers
  Measure measure;
  for (const std::uint64_t seed : {500'844U, 700'387U, 700'471U, 800'688U, 1'001'288U, 1'001'557U, 1'002'239U,
                                   1'200'469U, 1'200'504U, 2'001'694U, 4'000'471U, 4'000'477U})
    take(measure, seed);
  for (const std::string& each : measure.contradictions) UNSCOPED_INFO(each);
  CHECK(measure.contradictions.empty());
  CHECK(measure.explored == 12);
}

TEST_CASE("findings are true and complete for seeds that were not used to write the checks") {
  if (!is_long() || std::getenv("DIRECTOR_SEED") != nullptr) return;
  const std::uint64_t cases = from_environment("DIRECTOR_CASES", far_cases);
  for (const std::uint64_t first : far_ranges) {
    Measure measure;
    take_range(measure, first, cases);
    std::cout << "from seed " << first << ": ";
    print(measure);
    for (const std::string& each : measure.contradictions) UNSCOPED_INFO(each);
    CHECK(measure.contradictions.empty());
    CHECK(measure.explored == cases);
    CHECK(measure.share() >= least_reported_far);
  }
}

} // namespace
