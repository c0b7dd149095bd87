// SPDX-License-Identifier: MIT
#include "compiler/analysis/chains/overlaps.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>

using namespace director::analysis;
using director::compiler::GroupId;
using director::compiler::ProviderId;
using director::tests::Analysed;

namespace {

bool all(ProviderId) { return true; }

/// The same by comparing the claims of each two.
std::vector<bool> by_claims(const Branches& branches, const std::vector<GroupId>& tasks) {
  std::vector<bool> out(tasks.size(), false);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const std::vector<GroupId> a = Claims(branches, tasks[i]).groups(), b = Claims(branches, tasks[j]).groups();
      const bool meet =
          std::any_of(a.begin(), a.end(), [&](GroupId id) { return std::binary_search(b.begin(), b.end(), id); });
      if (meet) out[i] = out[j] = true;
    }
  }
  return out;
}

} // namespace

TEST_CASE("entries overlap where something is below two of them, and one may be below another") {
  const Analysed c(R"(
roots: [All]
groups:
  All: {tasks: [Walk, Talk, Look, Kick, Legs, Voice]}
  Walk: {needs: [Legs]}
  Kick: {tasks: [Swing]}
  Swing: {tasks: [Legs]}
  Talk: {tasks: [Voice]}
  Look: {}
  Legs: {}
  Voice: {}
)");
  const Branches branches(c.model, all);
  Overlaps overlaps(c.model, branches);
  const auto among = [&](std::initializer_list<const char*> names) {
    std::vector<GroupId> tasks;
    for (const char* name : names) tasks.push_back(c.group(name));
    return overlaps.among(tasks);
  };
  CHECK(among({"Walk", "Talk", "Look", "Kick"}) == std::vector<bool>{true, false, false, true});
  CHECK(among({"Walk", "Talk", "Look"}) == std::vector<bool>{false, false, false});
  CHECK(among({"Legs", "Look", "Kick"}) == std::vector<bool>{true, false, true});
  CHECK(among({"Talk", "Voice"}) == std::vector<bool>{true, true});
  CHECK(among({}).empty());
}

TEST_CASE("where no state rules anything out entries overlap exactly if their claims do") {
  std::mt19937 random(11);
  for (int round = 0; round < 200; ++round) {
    constexpr unsigned size = 14;
    std::string text = "roots: [T0]\ngroups:\n";
    for (unsigned i = 0; i < size; ++i) {
      std::string needs, tasks;
      for (unsigned j = round % 2 == 0 ? i + 1 : 0; j < size; ++j) { // every other one may have cycles
        if (i != j && random() % 9U == 0U) (random() % 2U == 0U ? needs : tasks) += fmt::format("T{}, ", j);
      }
      text += fmt::format("  T{}: {{needs: [{}], tasks: [{}]}}\n", i, needs, tasks);
    }
    const Analysed c(text);
    const Branches branches(c.model, all);
    Overlaps overlaps(c.model, branches);
    INFO(text);
    for (const director::compiler::Group& group : c.model.groups) {
      std::vector<GroupId> targets;
      for (const director::compiler::EdgeId id : c.model.edges.ids()) {
        const director::compiler::Edge& edge = c.model.edges[id];
        if (edge.requester && c.model.groups[*edge.requester].name.value == group.name.value && !edge.needed)
          targets.push_back(edge.target);
      }
      std::shuffle(targets.begin(), targets.end(), random);
      CHECK(overlaps.among(targets) == by_claims(branches, targets));
    }
  }
}
