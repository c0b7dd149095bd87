// SPDX-License-Identifier: MIT
#include "compiler/analysis/chains/claims.hpp"
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
