// SPDX-License-Identifier: MIT
#include "compiler/graph/clusters.hpp"
#include "compiler/lower/lower.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>

#include <map>

namespace {

using namespace director;
using namespace director::compiler;

/// For each task of `requester`, the first one that it is in a cluster with.
std::map<std::string, std::string> clusters_of(const std::string& groups, const std::string& requester) {
  const auto compiled = tests::compile("behaviour: test\nlanguage: 1\nroots: [All]\ngroups:\n" + groups);
  const IdTable<EdgeId, EdgeId> clusters = find_clusters(compiled.model);
  const Lowered lowered = lower(compiled.model);
  std::map<std::string, std::string> out;
  for (const EdgeId edge : compiled.model.edges.ids()) {
    CHECK(lowered.view().cluster(edge.value) == clusters[edge].value);
    const auto name = [&](EdgeId id) { return compiled.model.groups[compiled.model.edges[id].target].name.value; };
    const auto& from = compiled.model.edges[edge].requester;
    if (from && compiled.model.groups[*from].name.value == requester) out[name(edge)] = name(clusters[edge]);
  }
  return out;
}

TEST_CASE("tasks that can need the same group are in one cluster, however deep the need") {
  CHECK(clusters_of(R"(
  All: {tasks: [A, B, C, D]}
  A: {providers: [{name: one, needs: [Left]}, {name: two, needs: [Right]}]}
  B: {providers: [{name: one, needs: [Arms]}, {name: two}]}
  C: {}
  D: {needs: [Tail]}
  Arms: {needs: [Right]}
  Left: {}
  Right: {}
  Tail: {}
)",
                    "All") == std::map<std::string, std::string>{{"A", "A"}, {"B", "A"}, {"C", "C"}, {"D", "D"}});
}

TEST_CASE("a task that another one may need is in a cluster with it") {
  CHECK(clusters_of("  All: {tasks: [A, B, C]}\n  A: {}\n  B: {}\n  C: {needs: [B]}\n", "All") ==
        std::map<std::string, std::string>{{"A", "A"}, {"B", "B"}, {"C", "B"}});
}

TEST_CASE("two tasks that share nothing with each other are in one cluster by way of a third") {
  CHECK(clusters_of("  All: {tasks: [A, B, C]}\n  A: {needs: [Left]}\n  B: {needs: [Right]}\n  C: {needs: [Left, "
                    "Right]}\n  Left: {}\n"
                    "  Right: {}\n",
                    "All") == std::map<std::string, std::string>{{"A", "A"}, {"B", "A"}, {"C", "A"}});
}

TEST_CASE("what a group needs itself is in no cluster with its tasks") {
  CHECK(clusters_of("  All: {needs: [Hold], tasks: [A, B]}\n  Hold: {needs: [Left]}\n  A: {needs: [Left]}\n  B: {}\n"
                    "  Left: {}\n",
                    "All") == std::map<std::string, std::string>{{"A", "A"}, {"B", "B"}, {"Hold", "Hold"}});
}

TEST_CASE("what tasks request when they run puts them into no cluster") {
  CHECK(clusters_of("  All: {tasks: [A, B]}\n  A: {tasks: [Left]}\n  B: {tasks: [Left]}\n  Left: {}\n", "All") ==
        std::map<std::string, std::string>{{"A", "A"}, {"B", "B"}});
}

} // namespace
