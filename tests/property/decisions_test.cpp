// Compares the possible results of every decision with those of random small behaviours: nothing else happens.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/decisions/decisions.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/pipeline.hpp"
#include "tests/property/reached.hpp"
#include "tests/property/small_behaviour.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>

#include <iostream>

namespace {

using namespace director;
using namespace director::property;
using tests::from_environment;

TEST_CASE("every decision is among its possible results") {
  const auto first = from_environment<std::uint64_t>("DIRECTOR_SEED", 1);
  const std::uint64_t cases = tests::cases_of({.usual = 300, .slow = 20});
  std::size_t decided = 0, explored = 0, moments = 0, passes = 0, states = 0;
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    const std::string text = to_yaml(to_document(small_behaviour(seed)));
    dsl::MemoryFiles files;
    files.add("small.yaml", text);
    dsl::Sources sources;
    const compiler::Checked checked = compiler::check("small.yaml", files, sources, {});
    if (!checked.lowerable) continue;
    const compiler::Model& model = checked.model;
    const compiler::Ground ground(model);
    Reached reached(ground);
    compiler::SearchOptions how;
    how.bound = 30'000;
    how.threads = 1;
    how.look = [&](const compiler::Machine& machine) { reached.look(machine); };
    const compiler::Searched searched = compiler::search(ground, how);
    reached.take(searched);
    ++explored;
    const analysis::Facts facts = analysis::find_facts(model, checked.graph, analysis::Reported::as_is);
    analysis::Budget budget;
    const analysis::Decisions found = analysis::find_decisions(model, facts, analysis::Reported::as_is, budget);
    std::cout << "seed " << seed << " " << model.groups.size() << " groups, " << searched.states << " states, "
              << found.moments << " moments " << found.passes << " passes\n";
    moments += found.moments, passes += found.passes, states += searched.states;
    std::string wrong;
    const auto report = [&](const std::string& what) { wrong += "seed " + std::to_string(seed) + ": " + what + "\n"; };
    for (const compiler::ProviderId id : model.providers.ids()) {
      const compiler::GroupId group = model.providers[id].group;
      if (!found.decided.contains(group)) continue;
      if (reached.ran[id.value] && !found.runs.contains(id)) report(model.full_name(id) + " runs");
    }
    std::size_t all = 0;
    for (const compiler::GroupId id : model.groups.ids()) all += found.decided.contains(id) ? 1 : 0;
    decided += all == model.groups.size() ? 1 : 0;
    for (const compiler::EdgeId id : model.edges.ids()) {
      if (!found.decided.contains(model.edges[id].target)) continue;
      if (reached.requested[id.value] && !found.requested.contains(id)) report(model.edge_name(id) + " is requested");
      if (reached.granted[id.value] && !found.granted.contains(id)) report(model.edge_name(id) + " is granted");
    }
    const std::vector<WholePack> packs = whole_packs(model);
    for (std::size_t i = 0; i < packs.size(); ++i) {
      if (reached.whole[i] && found.decided.contains(model.providers[packs[i].provider].group) &&
          !found.whole.contains({packs[i].provider, packs[i].pack}))
        report("pack of " + model.full_name(packs[i].provider));
    }
    for (const auto& push : reached.pushed) {
      if (found.decided.contains(model.providers[push.first].group) && !found.pushed.contains(push))
        report(model.full_name(push.first) + " is pushed for " + model.conditions[push.second].text);
    }
    if (!wrong.empty()) std::cout << wrong << text;
    CHECK(wrong == "");
  }
  std::cout << explored << " explored, " << states << " states; decided " << decided << ", " << moments << " moments, "
            << passes << " passes\n";
}

} // namespace
