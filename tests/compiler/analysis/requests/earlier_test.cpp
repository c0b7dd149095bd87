// SPDX-License-Identifier: MIT
#include "compiler/analysis/requests/earlier.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

/// Whether the first request for `task` may exist while the state `A` is `value`.
bool may_exist(const std::string& text, const char* task, std::int64_t value) {
  const tests::Analysed test("states: {A: {range: [0, 9], initial: 0, external: true}, B: {values: [no, yes], initial: "
                             "no}}\n" +
                             text);
  const Requests requests(test.model, test.graph, test.facts);
  const Rivals rivals(test.model, test.facts.holding, test.facts.active);
  Budget budget;
  const Earlier earlier(test.model, test.facts, requests, rivals, budget);
  const Box box{{test.state("A"), {ValueSet::single(value), false}}};
  return earlier.may_exist(requests.of(test.group(task)).front(), box);
}

TEST_CASE("a request exists where no earlier provider of its requester can run") {
  const std::string text =
      "roots: [P]\ngroups:\n"
      "  P: {providers: [{name: a, when: [A < 3]}, {name: b, when: [A > 7]}, {name: c, tasks: [Q]}]}\n"
      "  Q: {}\n";
  CHECK_FALSE(may_exist(text, "Q", 2));
  CHECK(may_exist(text, "Q", 5));
  CHECK_FALSE(may_exist(text, "Q", 8));
  CHECK(may_exist(text, "P", 2)); // the program requests it
}

TEST_CASE("a request exists only where the requesters above it come first too") {
  const std::string text = "roots: [P, R]\ngroups:\n"
                           "  P: {providers: [{name: a, when: [A < 3]}, {name: b, tasks: [Q]}]}\n"
                           "  R: {providers: [{name: a, when: [A < 5]}, {name: b, tasks: [Q]}]}\n"
                           "  Q: {providers: [{name: a, when: [A == 4]}, {name: b, tasks: [S]}]}\n  S: {}\n";
  CHECK_FALSE(may_exist(text, "S", 2)); // neither P nor R requests Q
  CHECK(may_exist(text, "S", 3));       // P does
  CHECK_FALSE(may_exist(text, "S", 4));
  CHECK(may_exist(text, "S", 6));
}

TEST_CASE("an earlier provider with a need that another task may hold leaves the request") {
  const std::string text = "groups:\n  P: {providers: [{name: a, when: [A < 3], needs: [N]}, {name: b, tasks: [Q]}]}\n"
                           "  R: {needs: [N]}\n  N: {}\n  Q: {}\n";
  CHECK_FALSE(may_exist("roots: [P]\n" + text, "Q", 2));
  CHECK(may_exist("roots: [P, R]\n" + text, "Q", 2));
}

TEST_CASE("a pushed provider comes before earlier ones") {
  const std::string text = "groups:\n  P: {providers: [{name: a, when: [A < 3]}, {name: b, causing: [B == yes], tasks: "
                           "[Q]}]}\n  R: {when: [B == yes]}\n  Q: {}\n";
  CHECK_FALSE(may_exist("roots: {P: {priority: 1}}\n" + text, "Q", 2));
  CHECK(may_exist("roots: {P: {priority: 1}, R: {priority: 2}}\n" + text, "Q", 2));
}

TEST_CASE("a provider with a stay goes on only where no earlier one can run") {
  const std::string text = "roots: [P]\ngroups:\n"
                           "  P: {providers: [{name: a, when: [A < 3]}, {name: b, when: [A > 5], stay: [A > 1], tasks: "
                           "[Q]}]}\n  Q: {}\n";
  CHECK_FALSE(may_exist(text, "Q", 2));
  CHECK(may_exist(text, "Q", 4));
}

} // namespace
