// SPDX-License-Identifier: MIT
// On random behaviours: what the checks call unreachable is never reached, what is proven is refuted in no state, what
// is refuted can be played, and what all states prove happens in no random scenario. Prefetched states that are not
// used change nothing.
//
//   DIRECTOR_SEED   first seed, instead of 1
//   DIRECTOR_CASES  how many, instead of as many as take half a minute
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/explore/scenario/write_scenario.hpp"
#include "compiler/explore/verdict.hpp"
#include "tests/property/engine_run.hpp"
#include "tests/property/generate.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/same_searches.hpp"

#include <catch2/catch.hpp>

#include <iostream>

namespace {

using namespace director::property;
using namespace director;
using compiler::Assertion;
using compiler::GroupId;

/// All possible assertions about two of its groups.
void assert_all(compiler::Model& model) {
  std::size_t soft = 0;
  for (const GroupId a : model.groups.ids()) {
    for (const GroupId b : model.groups.ids()) {
      if (a == b) continue;
      const auto add = [&](Assertion::Kind kind) {
        Assertion assertion;
        assertion.kind = kind;
        assertion.groups = {{a, {}}, {b, {}}};
        model.assertions.push_back(assertion);
      };
      if (a < b) add(Assertion::Kind::never_together);
      add(Assertion::Kind::beats);
      if (soft++ < compiler::most_soft) add(Assertion::Kind::soft);
    }
  }
}

struct Case {
  std::unique_ptr<Compiled> compiled;
  std::string text;
};

Case make(std::uint64_t seed) {
  Random random(seed + 7'000'000);
  const Flavour flavour = random_flavour(random);
  const BehaviourDraft draft = random_behaviour(random, flavour, static_cast<std::size_t>(random.between(2, 4)));
  Case out;
  out.text = to_yaml(to_document(draft));
  CompileResult result = compile(out.text, to_yaml(random_scenario(random, flavour, draft)));
  if (result.compiled) assert_all(result.compiled->model);
  out.compiled = std::move(result.compiled);
  return out;
}

/// Whether a scenario does what no exploration tries: it disables providers, or begins elsewhere.
bool strays(const compiler::Scenario& scenario, const compiler::Model& model) {
  for (const compiler::Setting& given : scenario.given) {
    if (!model.states[given.state].external) return true;
  }
  for (const compiler::ScenarioStep& step : scenario.steps) {
    for (const compiler::ScenarioInput& input : step.inputs) {
      if (input.kind == dsl::InputSpec::Kind::disable) return true;
    }
  }
  return false;
}

/// The assertions `never_together` that a scenario refutes.
std::vector<std::size_t> refuted_by(const Compiled& compiled) {
  std::vector<std::size_t> out;
  EngineRun run(compiled, false);
  const auto look = [&] {
    for (std::size_t i = 0; i < compiled.model.assertions.size(); ++i) {
      const Assertion& assertion = compiled.model.assertions[i];
      if (assertion.kind != Assertion::Kind::never_together) continue;
      if (run.engine().granted(assertion.groups[0].id.value) && run.engine().granted(assertion.groups[1].id.value))
        out.push_back(i);
    }
  };
  for (const compiler::ScenarioStep& step : compiled.scenario.steps) {
    run.begin_step(step);
    for (int i = 0; i < 2'000 && run.micro_step(); ++i) look();
    look();
  }
  return out;
}

TEST_CASE("explorations agree with checks, with proofs, and with scenarios") {
  const auto first = tests::from_environment<std::uint64_t>("DIRECTOR_SEED", 1);
  constexpr tests::Series series{.usual = 150, .slow = 20};
  const std::uint64_t cases = tests::cases_of(series);
  std::size_t complete = 0, proven = 0, refuted = 0, not_played = 0, states = 0, scenarios = 0;
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    const Case each = make(seed);
    if (!each.compiled) continue;
    const compiler::Model& model = each.compiled->model;
    INFO("DIRECTOR_SEED=" << seed << "\n" << each.text);
    const compiler::Ground ground(model);
    compiler::SearchOptions options;
    options.bound = 4'000;
    options.threads = 1;
    for (std::size_t i = 0; i < model.assertions.size(); ++i) options.assertions.push_back(i);
    const compiler::Searched searched = compiler::search(ground, options);
    if (seed % 3 == 0) CHECK(tests::search_both_ways(ground, options).empty());
    complete += searched.complete ? 1 : 0;
    states += searched.states;

    const analysis::Facts facts = analysis::find_facts(model, compiler::make_graph(model));
    for (const compiler::ProviderId id : model.providers.ids()) {
      if (!searched.happened.ran[id.value]) continue;
      INFO(model.full_name(id) << " ran");
      CHECK(facts.active.contains(id));
    }
    for (std::size_t i = 0; i < model.assertions.size(); ++i) {
      const Assertion& assertion = model.assertions[i];
      INFO(words_of(assertion, model));
      if (compiler::prove_at_once(assertion, model)) {
        ++proven;
        const bool is_refuted =
            searched.seen[i] && compiler::Follower(ground, searched.breadth).shows(*searched.seen[i], i);
        CHECK_FALSE(is_refuted);
      }
      if (!searched.seen[i] || i % 5 != seed % 5) continue; // each counterexample is played; a fifth is enough
      ++refuted;
      CHECK(compiler::Follower(ground, searched.breadth).shows(*searched.seen[i], i));
      const auto way = compiler::Follower(ground, searched.breadth).follow(*searched.seen[i]);
      if (!compiler::write_scenario(ground, way, {"found", "Played.", "behaviour.yaml", {}})) ++not_played;
    }
    if (!searched.complete || strays(each.compiled->scenario, model)) continue;
    ++scenarios;
    for (const std::size_t i : refuted_by(*each.compiled)) {
      INFO(words_of(model.assertions[i], model));
      CHECK(searched.seen[i].has_value());
    }
  }
  std::cout << cases << " behaviours from seed " << first << ", " << complete << " explored to the end, " << states
            << " states; " << proven << " assertions proven at once; " << refuted << " ways played, " << not_played
            << " of them not as they were found; " << scenarios << " random scenarios beside complete explorations\n";
  if (cases < (tests::is_slow ? series.slow : series.usual)) return;
  CHECK(complete * 4 >= cases);
  CHECK(not_played * 20 <= refuted);
}

} // namespace
