// SPDX-License-Identifier: MIT
#include "compiler/lower/plans.hpp"
#include "tests/compiler/support/compiled.hpp"

using namespace director::compiler;
using director::tests::compile;
using director::tests::Compiled;

namespace {

std::vector<std::string> names(const Compiled& c, const std::vector<ProviderId>& ids) {
  std::vector<std::string> out;
  for (const ProviderId id : ids) out.push_back(c.model.full_name(id));
  return out;
}

using Texts = std::vector<std::string>;

const char* const forked = R"(
behaviour: forked
language: 1
roots: [Top]
groups:
  Top: {needs: [A, B]}
  A: {providers: [{name: x, needs: [C]}, {name: y, needs: [B]}, {name: z, needs: [D]}]}
  B: {needs: [C]}
  C: {}
  D: {needs: [E]}
  E: {providers: [{name: p}, {name: q}]}
)";

} // namespace

TEST_CASE("a provider that takes what another need takes is in no plan") {
  const Compiled c = compile(forked);
  const PlanProviders plans = providers_in_plans(c.model, c.provider("Top"));
  CHECK(plans.exact);
  CHECK(names(c, plans.providers) == Texts{"A.z", "B", "C", "D", "E.p", "E.q"});
}

TEST_CASE("a provider without needs has one empty plan") {
  const Compiled c = compile(forked);
  const PlanProviders plans = providers_in_plans(c.model, c.provider("C"));
  CHECK(plans.exact);
  CHECK(plans.providers.empty());
}

TEST_CASE("a group that is needed in a cycle is in no plan of its own") {
  const Compiled c = compile(R"(
behaviour: circle
language: 1
roots: [A]
groups:
  A: {needs: [B]}
  B: {providers: [{name: back, needs: [A]}, {name: out}]}
)");
  CHECK(names(c, providers_in_plans(c.model, c.provider("A")).providers) == Texts{"B.out"});
}

TEST_CASE("beyond the bound everything that may be needed counts, and it is reported") {
  const Compiled c = compile(forked);
  const PlanProviders plans = providers_in_plans(c.model, c.provider("Top"), 4);
  CHECK(!plans.exact);
  CHECK(names(c, plans.providers) == Texts{"A.x", "A.y", "A.z", "B", "C", "D", "E.p", "E.q"});
}
