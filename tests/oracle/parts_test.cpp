// SPDX-License-Identifier: MIT
#include "tests/oracle/text.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director::oracle;

std::string shown(const Model& model, const Plan& plan) {
  std::string out;
  for (const PlanEntry& entry : plan) {
    out += (out.empty() ? "" : " ") + model.full_name(entry.provider) + "<" + model.groups[entry.needer].name.value;
  }
  return out;
}

TEST_CASE("plans come in order of preference, depth first, and take no group twice") {
  const Model model = model_of(R"(
behaviour: plans
language: 1
roots: [A]
groups:
  A: {needs: [B, C], tasks: [B, C]}
  B: {providers: [{name: x, needs: [D]}, {name: y, needs: [C]}, {name: z}]}
  C: {providers: [{name: x, needs: [D]}, {name: y}]}
  D: {}
)");
  const Parts parts(model);
  std::vector<std::string> plans;
  for (const Plan& plan : parts.plans(model.groups[*model.find_group("A")].providers.front()))
    plans.push_back(shown(model, plan));
  CHECK(plans == std::vector<std::string>{"B.x<A D<B C.y<A", "B.z<A C.x<A D<C", "B.z<A C.y<A"});
}

TEST_CASE("a group may request all that its tasks and needs lead to, directly or not") {
  const Model model = model_of(R"(
behaviour: reach
language: 1
roots: [A, C]
groups:
  A: {tasks: [B]}
  B: {needs: [D], tasks: [D]}
  C: {tasks: [D]}
  D: {}
)");
  const Parts parts(model);
  const auto may = [&](const char* from, const char* to) {
    return parts.may_ask_for(*model.find_group(from), *model.find_group(to));
  };
  CHECK(may("A", "D"));
  CHECK(!may("A", "A"));
  CHECK(!may("C", "B"));
}

} // namespace
