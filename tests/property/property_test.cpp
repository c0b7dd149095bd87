// SPDX-License-Identifier: MIT
// The main property of the engine: on random behaviours and scenarios it does what the oracle does, micro-step by
// micro-step.
//
//   DIRECTOR_SEED   first seed, instead of 1
//   DIRECTOR_CASES  how many, instead of as many as take a minute or two
//
// A case that fails is shrunk and written to <build>/tests/property, ready for `directorc simulate`.
#include "tests/property/compare.hpp"
#include "tests/property/shrink.hpp"
#include "tests/property/watch.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>

namespace {

using namespace director::property;
using director::tests::from_environment;

constexpr director::tests::Series of_all{.usual = 5'000, .slow = 300, .whole = 8'000};
constexpr int parts = 4; // of the cases: ctest runs them in parallel

Verdict verdict_of(const Documents& documents, Manner manner) {
  const CompileResult result = compile(to_yaml(documents.behaviour), to_yaml(documents.scenario));
  if (!result.compiled) {
    Verdict refused;
    refused.difference = "the documents are not valid: " + result.why;
    return refused;
  }
  return compare(*result.compiled, manner);
}

/// The kind of a difference, without its place: a case is not reduced to one that fails for another reason.
std::string kind_of(const std::string& difference) {
  for (const std::string_view kind : {"reported otherwise", "simulated", "does not come to rest"}) {
    if (difference.find(kind) != std::string::npos) return std::string(kind);
  }
  return difference.empty() ? "" : "decided otherwise";
}

/// The smallest case that still differs in this way: its text, and its path.
std::string minimal(const Documents& documents, std::uint64_t seed, const std::string& difference) {
  const Manner manner = manner_of(seed);
  const Documents small = shrink(documents, [&](const Documents& candidate) {
    const CompileResult result = compile(to_yaml(candidate.behaviour), to_yaml(candidate.scenario));
    return result.compiled && kind_of(compare(*result.compiled, manner).difference) == kind_of(difference);
  });
  const auto folder = director::tests::binary_dir() / "tests" / "property" / ("seed_" + std::to_string(seed));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "behaviour.yaml") << to_yaml(small.behaviour);
  std::ofstream(folder / "random.scenario.yaml") << to_yaml(small.scenario);
  return "minimal case, in " + folder.string() +
         (manner == Manner::in_leaps ? " (with time in leaps)"
          : manner == Manner::often  ? " (played four times)"
                                     : "") +
         "\n" + to_yaml(small.behaviour) + "---\n" + to_yaml(small.scenario) + "---\n" +
         verdict_of(small, manner).difference;
}

struct Shares {
  std::array<std::uint64_t, static_cast<std::size_t>(Show::count)> shown{};
  std::array<std::uint64_t, kinds_of_claims> claimed{};
  std::uint64_t cases = 0, micro_steps = 0;
  std::size_t settling = 0;
  double dearest = 0;

  void add(const Verdict& verdict) {
    ++cases;
    micro_steps += verdict.micro_steps;
    settling = std::max(settling, verdict.settling);
    dearest = std::max(dearest, verdict.dearest);
    for (std::size_t i = 0; i < shown.size(); ++i) shown[i] += verdict.shown[i] ? 1 : 0;
    for (std::size_t i = 0; i < claimed.size(); ++i) claimed[i] += verdict.claimed[i] ? 1 : 0;
  }
  double percent(Show what) const {
    return 100.0 * static_cast<double>(shown[static_cast<std::size_t>(what)]) / static_cast<double>(cases);
  }
  void print(std::uint64_t first) const {
    std::cout << cases << " cases from seed " << first << ", " << micro_steps << " micro-steps, at most " << settling
              << " in a row that only settle, at most " << 100 * dearest
              << " % of the work that is their bound. Scenarios with\n"
              << std::fixed << std::setprecision(1);
    for (std::size_t i = 0; i < shown.size(); ++i)
      std::cout << std::setw(7) << percent(static_cast<Show>(i)) << " %  " << show_names[i] << "\n";
    std::cout << "and in which why said so much, kind by kind: ";
    for (const std::uint64_t each : claimed)
      std::cout << 100.0 * static_cast<double>(each) / static_cast<double>(cases) << " % ";
    std::cout << "\n";
  }
};

/// `of`: the kind of these cases, for messages.
Shares compare_cases(std::uint64_t first, std::uint64_t count, Documents (*make)(std::uint64_t), const char* of) {
  Shares shares;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    watch(seed);
    const Documents documents = make(seed);
    const Verdict verdict = verdict_of(documents, manner_of(seed));
    stop_watching();
    if (!verdict.difference.empty())
      FAIL("DIRECTOR_SEED=" << seed << of << " differs, " << verdict.difference << "\n"
                            << minimal(documents, seed, verdict.difference));
    shares.add(verdict);
  }
  shares.print(first);
  return shares;
}

void run_part(int part) {
  const std::uint64_t all = director::tests::cases_of(of_all);
  const std::uint64_t share = (all + parts - 1) / parts;
  const auto first = from_environment<std::uint64_t>("DIRECTOR_SEED", 1) + static_cast<std::uint64_t>(part) * share;
  const Shares shares = compare_cases(first, share, generate, "");
  if (share < 1'000) return; // too few for stable shares: a build without optimisation only compares
  for (const std::uint64_t each : shares.claimed) CHECK(each > 0);
  // The situations that the cases must contain for agreement to mean something.
  CHECK(shares.percent(Show::push) >= 20);
  for (const Show what : {Show::ladder, Show::denial_by_an_equal, Show::limbo, Show::alternative_plan,
                          Show::level_change, Show::dropped_push}) {
    INFO(show_names[static_cast<std::size_t>(what)]);
    CHECK(shares.percent(what) >= 5);
  }
}

/// There are half as many of these cases as in each part of the others.
void run_special(Documents (*make)(std::uint64_t), const char* of) {
  const std::uint64_t cases = director::tests::cases_of(of_all) / (2 * parts);
  const auto first = from_environment<std::uint64_t>("DIRECTOR_SEED", 1);
  compare_cases(first, cases, make, of);
}

TEST_CASE("the engine does what the oracle does, in the first part of the random cases") { run_part(0); }
TEST_CASE("the engine does what the oracle does, in the second part of the random cases") { run_part(1); }
TEST_CASE("the engine does what the oracle does, in the third part of the random cases") { run_part(2); }
TEST_CASE("the engine does what the oracle does, in the last part of the random cases") { run_part(3); }
TEST_CASE("the engine does what the oracle does, in behaviours of several parts") {
  run_special(generate_parts, " of several parts");
}
TEST_CASE("the engine does what the oracle does, if a unit changes its place in the order") {
  run_special(generate_moving_unit, " of units that move");
}
TEST_CASE("the engine does what the oracle does, if most edges are equal") {
  run_special(generate_equals, " of equals");
}
TEST_CASE("the engine does what the oracle does, if bodies change their requests in many runs") {
  run_special(generate_long, " of long games");
}

} // namespace
