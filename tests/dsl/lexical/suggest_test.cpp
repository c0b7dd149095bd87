// SPDX-License-Identifier: MIT
#include "dsl/lexical/suggest.hpp"

#include <catch2/catch.hpp>

namespace {

using director::dsl::suggest;
const std::vector<std::string> names{"Walk", "WalkTo", "Kick", "LeftLeg", "LeftArm"};

TEST_CASE("for a misspelt word the nearest one is suggested") {
  CHECK(suggest("Wlak", names) == "Walk");
  CHECK(suggest("Kicks", names) == "Kick");
  CHECK(suggest("LeftLge", names) == "LeftLeg");
  CHECK(suggest("WalkTp", names) == "WalkTo");
}

TEST_CASE("a word in another case is nearer than a word with other letters") {
  CHECK(suggest("walk", names) == "Walk");
  CHECK(suggest("WALK", names) == "Walk");
  CHECK(suggest("b", {"a", "B"}) == "B");
}

TEST_CASE("a word that is like no other gets no suggestion") {
  CHECK_FALSE(suggest("Grasp", names));
  CHECK_FALSE(suggest("", names));
  CHECK_FALSE(suggest("b", {"a"}));
  CHECK_FALSE(suggest("Walk", {}));
  CHECK_FALSE(suggest(std::string(101, 'a'), {std::string(100, 'a')}));
}

TEST_CASE("for a word that is not complete the only one that begins like it is suggested") {
  CHECK(suggest("assert", {"allow", "assertions"}) == "assertions");
  CHECK(suggest("pri", {"priority", "optional"}) == "priority");
  CHECK_FALSE(suggest("pr", {"priority", "optional"}));
  CHECK(suggest("cam", {"cam", "camera_front"}) == "camera_front"); // the word itself is none that begins like it
  CHECK_FALSE(suggest("Left", names));
}

TEST_CASE("of equally near words the first one counts") { CHECK(suggest("Left", {"Lift", "Loft"}) == "Lift"); }

} // namespace
