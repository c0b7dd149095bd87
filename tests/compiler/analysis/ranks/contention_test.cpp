// SPDX-License-Identifier: MIT
#include "compiler/analysis/ranks/contention.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <fmt/format.h>

using namespace director::analysis;
using director::tests::compile;
using director::tests::Compiled;

namespace {

using Texts = std::vector<std::string>;

Texts decided(const Compiled& c, const std::string& group, std::size_t pairs = most_edge_pairs,
              std::size_t partings = most_partings) {
  Texts out;
  for (const Contention& each : Contentions(c.model, pairs, partings).at(c.group(group))) {
    out.push_back(c.model.edge_name(each.first) + " and " + c.model.edge_name(each.second) +
                  (each.complete ? "" : " (cut)"));
    for (const Decision& decision : each.decisions) {
      const auto side = [&](EdgeId sibling, SideRank way) {
        return fmt::format("{} {}{}", c.model.edge_name(sibling), way.priority, way.optional ? "?" : "");
      };
      out.push_back(fmt::format("  {}, {}: {}", side(decision.first_sibling, decision.first),
                                side(decision.second_sibling, decision.second), order_of(decision)));
    }
  }
  return out;
}

} // namespace

TEST_CASE("the edges below the closest common requester decide") {
  const Compiled c = compile(R"(
behaviour: closest
language: 1
roots: {A: {priority: 1}, B: {priority: 2}}
groups:
  A: {tasks: {C: {priority: 5}, D: {priority: 5}}}
  B: {tasks: [Leg]}
  C: {tasks: {Leg: {priority: 90}}}
  D: {tasks: [Leg]}
  Leg: {}
)");
  CHECK(decided(c, "Leg") == Texts{"B>Leg and C>Leg", "  root>B 2, root>A 1: -1", "B>Leg and D>Leg",
                                   "  root>B 2, root>A 1: -1", "C>Leg and D>Leg", "  A>C 5, A>D 5: 0"});
}

TEST_CASE("something optional on the way down weakens the whole chain") {
  const Compiled c = compile(R"(
behaviour: optional
language: 1
roots: {A: {priority: 1}, B: {priority: 2}}
groups:
  A: {tasks: [Leg]}
  B: {tasks: {C: {optional: true}}}
  C: {tasks: [Leg]}
  Leg: {}
)");
  CHECK(decided(c, "Leg") == Texts{"A>Leg and C>Leg", "  root>A 1, root>B 2?: -1"});
}

TEST_CASE("every level counts, and a need counts as mandatory with the priority of the first level") {
  const Compiled c = compile(R"(
behaviour: levels
language: 1
roots: {A: {priority: {low: 1, high: 9}}, B: {priority: 5}}
groups:
  A: {providers: [{name: strong, needs: [Leg]}, {name: weak, tasks: {Leg: {optional: true}}}]}
  B: {tasks: [Leg]}
  Leg: {}
)");
  CHECK(decided(c, "Leg") == Texts{"A>Leg and B>Leg", "  root>A 1, root>B 5: 1", "  root>A 1?, root>B 5: 1",
                                   "  root>A 9, root>B 5: -1", "  root>A 9?, root>B 5: 1"});
}

TEST_CASE("what is needed and requested as optional too is held by the need, and what that requests is optional") {
  const Compiled c = compile(R"(
behaviour: needed
language: 1
roots: {Walk: {priority: 1}, Look: {priority: 2, optional: true}}
groups:
  Walk: {needs: [Head], tasks: {Head: {optional: true}}}
  Look: {needs: [Head], tasks: [Head, Neck]}
  Head: {tasks: [Neck]}
  Neck: {}
)");
  CHECK(decided(c, "Head") == Texts{"Walk>Head and Look>Head", "  root>Walk 1, root>Look 2?: -1"});
  CHECK(decided(c, "Neck") == Texts{"Look>Neck and Head>Neck", "  root>Look 2?, root>Walk 1: 1",
                                    "  root>Look 2?, root>Walk 1?: -1", "  Look>Neck 0, Look>Head 0: 0"});
}

TEST_CASE(
    "what only one provider needs and requests as optional too is optional once another provider has the request") {
  const Compiled c = compile(R"(
behaviour: changed
language: 1
roots: {Walk: {priority: 10}, Look: {priority: 10}}
groups:
  Walk: {providers: [{name: looking, needs: [Head], tasks: {Head: {optional: true}}}, {name: waving}]}
  Look: {needs: [Head], tasks: [Head]}
  Head: {}
)");
  CHECK(decided(c, "Head") ==
        Texts{"Walk>Head and Look>Head", "  root>Walk 10, root>Look 10: 0", "  root>Walk 10?, root>Look 10: 1"});
}

TEST_CASE("two chains that would meet in a group cannot exist side by side") {
  const Compiled c = compile(R"(
behaviour: meet
language: 1
roots: {A: {priority: 1}, B: {priority: 2}}
groups:
  A: {tasks: [C]}
  B: {tasks: [C]}
  C: {tasks: {D: {priority: 3}, E: {priority: 4}}}
  D: {tasks: [Leg]}
  E: {tasks: [Leg]}
  Leg: {}
)");
  CHECK(decided(c, "Leg") == Texts{"D>Leg and E>Leg", "  C>D 3, C>E 4: 1"});
}

TEST_CASE("an edge that no chain from root leads to contends with no other") {
  const Compiled c = compile(R"(
behaviour: lost
language: 1
roots: [A]
groups:
  A: {tasks: [Leg]}
  B: {tasks: [Leg]}
  Leg: {}
)");
  CHECK(decided(c, "Leg") == Texts{"A>Leg and B>Leg"});
}

TEST_CASE("a search that ends at its bound reports it") {
  const Compiled c = compile(R"(
behaviour: bound
language: 1
roots: [A, B]
groups:
  A: {tasks: [C, D]}
  B: {tasks: [C, D]}
  C: {tasks: [Leg]}
  D: {tasks: [Leg]}
  Leg: {}
)");
  CHECK(decided(c, "Leg", 3) == Texts{"C>Leg and D>Leg (cut)", "  A>C 0, A>D 0: 0"});
  CHECK(decided(c, "Leg", most_edge_pairs, 1) == Texts{"C>Leg and D>Leg (cut)", "  A>C 0, A>D 0: 0"});
  const Texts all = decided(c, "Leg");
  CHECK(all.front() == "C>Leg and D>Leg");
  CHECK(all.size() > 2);
}

TEST_CASE("where requests form a cycle, two chains may part at any group of it") {
  const Compiled c = compile(R"(
behaviour: circle
language: 1
roots: [A, B]
groups:
  A: {tasks: {B: {optional: true}, Leg: {priority: 5}}}
  B: {packs: {with: {A: {priority: 3}, Leg: {priority: 7}}}}
  Leg: {}
)");
  CHECK(decided(c, "Leg") ==
        Texts{"A>Leg and B>Leg", "  root>A 0, root>B 0: 0", "  A>Leg 5, A>B 0?: -1", "  B>A 3, B>Leg 7: 1"});
}
