// SPDX-License-Identifier: MIT
#include "compiler/base/choice_sequence.hpp"

#include <catch2/catch.hpp>

#include <string>

namespace {

using namespace director::compiler;

/// Picks one of two, and after the first one of three.
std::string way_through(ChoiceSequence& choices) {
  std::string out = std::to_string(choices.pick(2));
  out += std::to_string(choices.pick(1));
  if (out == "00") out += std::to_string(choices.pick(3));
  return out;
}

std::string all_ways(ChoiceSequence& choices) {
  std::string out;
  do out += way_through(choices) + " ";
  while (choices.next());
  return out;
}

TEST_CASE("each way through is taken once, the last pick first") {
  ChoiceSequence choices;
  CHECK(all_ways(choices) == "000 001 002 10 ");
  choices.begin();
  CHECK(all_ways(choices) == "000 001 002 10 ");
}

TEST_CASE("given picks stay, also where there is no choice") {
  ChoiceSequence choices;
  choices.begin({0, 0});
  CHECK(all_ways(choices) == "000 001 002 ");
  choices.begin({1, 0});
  CHECK(all_ways(choices) == "10 ");
}

TEST_CASE("a way is usual if it takes the first of everything, and is new after the first pick that differs") {
  ChoiceSequence choices;
  way_through(choices);
  CHECK(choices.usual());
  CHECK(choices.next());
  CHECK(choices.pick(2) == 0);
  CHECK_FALSE(choices.has_picked());
  CHECK(choices.pick(3) == 1);
  CHECK(choices.has_picked());
  CHECK_FALSE(choices.usual());
}

} // namespace
