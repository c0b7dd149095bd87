// SPDX-License-Identifier: MIT
#include "compiler/model/model.hpp"

#include <catch2/catch.hpp>

using director::compiler::ListedValues;
using director::compiler::State;

TEST_CASE("a listed value is found by its word, and has the number in which it was added") {
  ListedValues values;
  CHECK(values.empty());
  CHECK(values.add("sit"));
  CHECK(values.add("stand"));
  CHECK_FALSE(values.add("sit"));
  CHECK(values.words() == std::vector<std::string>{"sit", "stand"});
  CHECK(values.find("sit") == 0);
  CHECK(values.find("stand") == 1);
  CHECK_FALSE(values.find("").has_value());
  CHECK_FALSE(values.find("stan").has_value());
  ListedValues copy = values;
  CHECK(copy.add("walk"));
  CHECK(copy.find("walk") == 2);
  CHECK_FALSE(values.find("walk").has_value());
}

TEST_CASE("each of a hundred thousand values of a state is found") {
  State state;
  for (std::int64_t i = 0; i < 100'000; ++i) state.values.add("v" + std::to_string(i * 7 % 100'000));
  state.high = 99'999;
  std::int64_t right = 0;
  for (std::int64_t i = 0; i < 100'000; ++i) right += state.value_of(state.value_text(i)) == i ? 1 : 0;
  CHECK(right == 100'000);
  CHECK_FALSE(state.value_of("v100000").has_value());
}
