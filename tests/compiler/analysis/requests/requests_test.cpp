// SPDX-License-Identifier: MIT
#include "compiler/analysis/requests/requests.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

struct Asked : tests::Analysed {
  using Analysed::Analysed;
  Requests requests{model, graph, facts};
  ValueSet values(const char* group, const char* state) const {
    const Region& region = requests.region(this->group(group));
    const auto at = region.states.find(this->state(state));
    return at == region.states.end() ? ValueSet::interval(-1, -1) : at->second;
  }
};

TEST_CASE("a request exists where all groups above it can run") {
  const Asked asked("states: {A: {range: [0, 9], initial: 0, external: true}}\nroots: [P]\ngroups:\n"
                    "  P: {when: [A > 2], stay: [A > 1], packs: {only: {Q: {}}}}\n"
                    "  Q: {when: [A < 8], packs: {only: {R: {}}}}\n  R: {}\n");
  CHECK(asked.values("P", "A") == ValueSet::interval(-1, -1));
  CHECK(asked.values("Q", "A") == ValueSet::interval(2, 9));
  CHECK(asked.values("R", "A") == ValueSet::interval(2, 7));
}

TEST_CASE("a request for a need of its requester exists only where that can run") {
  const Asked asked("states: {A: {range: [0, 9], initial: 0, external: true}}\nroots: [P]\ngroups:\n"
                    "  P: {providers: [{name: a, needs: [Q], packs: {only: {Q: {}}}}, {name: b}]}\n"
                    "  Q: {when: [A < 8]}\n");
  CHECK(asked.values("Q", "A") == ValueSet::interval(0, 7));
}

TEST_CASE("two requesters open the region around both") {
  const Asked asked("states: {A: {range: [0, 9], initial: 0, external: true}}\nroots: [P, Q]\ngroups:\n"
                    "  P: {when: [A == 1], packs: {only: {R: {}}}}\n  Q: {when: [A == 3], packs: {only: {R: {}}}}\n"
                    "  R: {}\n");
  CHECK(asked.values("R", "A") == ValueSet::single(1).united(ValueSet::single(3)));
  CHECK(asked.requests.of(asked.compiled.group("R")).size() == 2);
}

} // namespace
