// SPDX-License-Identifier: MIT
#include "compiler/analysis/chains/claims.hpp"
#include "compiler/analysis/chains/runs_below.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

using namespace director::analysis;
using director::tests::Analysed;

TEST_CASE("a way down ends at the task, also where needs lead back to it") {
  const Analysed c(R"(
roots: [Walk]
groups:
  Walk: {needs: [Legs]}
  Legs: {providers: [{name: led, needs: [Walk]}, {name: free, needs: [Hip]}]}
  Hip: {}
)");
  const auto all = [](director::compiler::ProviderId) { return true; };
  const Branches branches(c.model, all);
  const Claims claims(branches, c.group("Walk"));
  CHECK(claims.path(c.group("Walk"), Reach::own).empty());
  const std::vector<ChainStep> path = claims.path(c.group("Hip"), Reach::own);
  REQUIRE(path.size() == 2);
  CHECK(path[0].from == c.group("Walk"));
  CHECK(path[0].to == c.group("Legs"));
  CHECK(path[1].to == c.group("Hip"));
}

TEST_CASE("what a task needs runs below it only where it is requested too, and only then with what that requests") {
  const Analysed c(R"(
roots: [Walk]
groups:
  Walk: {needs: [Legs, Arms], tasks: [Legs]}
  Legs: {needs: [Hip], tasks: [Foot]}
  Arms: {tasks: [Hand]}
  Hip: {}
  Foot: {}
  Hand: {}
)");
  const auto all = [](director::compiler::ProviderId) { return true; };
  const Branches branches(c.model, all);
  const GroupId above = c.group("Walk"), legs = c.group("Legs"), foot = c.group("Foot");
  const Claims claims(branches, above);
  const RunsBelow below(branches, claims, above);
  CHECK(below.groups() == std::vector<GroupId>{above, legs, foot});
  CHECK_FALSE(below.contains(c.group("Hip")));
  CHECK(below.path(above).empty());
  const std::vector<ChainStep> path = below.path(foot);
  REQUIRE(path.size() == 2);
  CHECK(path[0].from == above);
  CHECK(path[0].to == legs);
  CHECK(path[1].to == foot);
}

TEST_CASE("a group runs below a task only where the conditions on the way do not exclude each other") {
  const Analysed c(R"(
states: {S: {values: [a, b], external: true}}
roots: [Walk]
groups:
  Walk: {when: [S == a], tasks: [Legs]}
  Legs: {providers: [{name: one, when: [S == a]}, {name: two, tasks: [Foot], when: [S == b]}]}
  Foot: {}
)");
  const auto all = [](director::compiler::ProviderId) { return true; };
  const Branches branches(c.model, all);
  const Claims claims(branches, c.group("Walk"));
  const RunsBelow below(branches, claims, c.group("Walk"));
  CHECK(below.contains(c.group("Legs")));
  CHECK_FALSE(below.contains(c.group("Foot")));
}

TEST_CASE("with one provider and one pack a task claims what that provider needs and that pack requests, and no more") {
  const Analysed c(R"(
roots: [Play]
groups:
  Play: {providers: [{name: one, needs: [Hip], packs: {a: {Walk: {}}, b: {Kick: {}}}}, {name: two, tasks: [Look]}]}
  Walk: {tasks: [Legs]}
  Kick: {}
  Look: {}
  Legs: {}
  Hip: {}
)");
  const auto all = [](director::compiler::ProviderId) { return true; };
  const Branches branches(c.model, all);
  const GroupId play = c.group("Play");
  const director::compiler::ProviderId one = c.provider("Play.one");
  const Branches walking = branches.with(one, &c.model.providers[one].packs[0]);
  const Claims claims(walking, play);
  CHECK(claims.groups() == std::vector<GroupId>{play, c.group("Walk"), c.group("Legs"), c.group("Hip")});
  CHECK(RunsBelow(walking, claims, play).groups() == std::vector<GroupId>{play, c.group("Walk"), c.group("Legs")});
  CHECK(Claims(branches.with(one, nullptr), play).groups() == std::vector<GroupId>{play, c.group("Hip")});
}
