// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

TEST_CASE("lists are worded as in a sentence") {
  CHECK(list_of({}).empty());
  CHECK(list_of({"`a`"}) == "`a`");
  CHECK(list_of({"`a`", "`b`"}) == "`a` and `b`");
  CHECK(list_of({"a", "b", "c"}, "or") == "a, b or c");
}

TEST_CASE("values and chains in words") {
  const tests::Analysed test(R"(states:
  Pose: {values: [a, b, c], external: true}
  Charge: {range: [0, 100], external: true}
roots: [A]
groups: {A: {tasks: [B]}, B: {tasks: [C]}, C: {}}
)");
  const auto& pose = test.model.states[test.state("Pose")];
  const auto& charge = test.model.states[test.state("Charge")];
  CHECK(values_in_words(pose, pose.domain()) == "a, b or c");
  CHECK(values_in_words(pose, {}) == "nothing");
  CHECK(values_in_words(charge, charge.domain().without(ValueSet::interval(1, 98))) == "0 or 99 to 100");
  const GroupId a = test.group("A"), b = test.group("B"), c = test.group("C");
  CHECK(chain_in_words(test.model, {a, b, c}, "requests") == "`A` requests `B`, which requests `C`");
  CHECK(chain_in_words(test.model, {a, b, a}, "needs") == "`A` needs `B`, which needs `A` again");
  std::vector<GroupId> chain(30, b);
  chain.front() = a;
  chain.back() = c;
  CHECK(chain_in_words(test.model, chain, "needs") ==
        "`A` needs `B`, which needs `B`, which needs `B`, which needs `B`, which needs `B`, which by 17 more leads to "
        "`B`, which needs `B`, which needs `B`, which needs `B`, which needs `B`, which needs `B`, which needs `C`");
}

TEST_CASE("of many notes the first ones and the last one are kept, and how many more there are") {
  std::vector<dsl::Note> notes{{{}, "one"}, {{}, "two"}, {{}, "three"}, {{}, "four"}};
  shorten(notes, 4);
  CHECK(notes.size() == 4);
  shorten(notes, 3);
  REQUIRE(notes.size() == 3);
  CHECK(notes[0].message == "one");
  CHECK(notes[1].message == "and 2 more of such notes, before the last one");
  CHECK(notes[2].message == "four");
}

TEST_CASE("of many notes of a list the first ones are kept, and followed by the number of the rest") {
  std::vector<dsl::Note> notes{{{}, "one"}, {{}, "two"}, {{}, "three"}, {{}, "four"}};
  shorten_list(notes, 4);
  CHECK(notes.size() == 4);
  shorten_list(notes, 3);
  REQUIRE(notes.size() == 3);
  CHECK(notes[0].message == "one");
  CHECK(notes[1].message == "two");
  CHECK(notes[2].message == "and 2 more of such notes, from here on");
}

} // namespace
