// SPDX-License-Identifier: MIT
#include "compiler/explore/search/known.hpp"

#include <catch2/catch.hpp>

#include <random>

using namespace director::compiler;

TEST_CASE("what was added is found again by its key, however much there is, and nothing else is") {
  std::mt19937_64 random(1);
  std::vector<std::uint64_t> keys(100'000);
  for (std::uint64_t& key : keys) key = random() | 1;
  Known known;
  for (Number i = 0; i < keys.size(); ++i) {
    REQUIRE_FALSE(known.has(keys[i]));
    known.add(keys[i], i);
  }
  for (Number i = 0; i < keys.size(); ++i) REQUIRE(known.find(keys[i]) == i);
  for (int i = 0; i < 1'000; ++i) CHECK(known.find(random() & ~std::uint64_t{1}) == none);
}

TEST_CASE("keys that begin or end alike are distinguished") {
  KeyTable table(8);
  for (Number i = 1; i <= 100; ++i) table.add(std::uint64_t{i} << 40, i);
  for (Number i = 1; i <= 100; ++i) CHECK(table.find(std::uint64_t{i} << 40) == i);
  CHECK(table.find(std::uint64_t{101} << 40) == none);
  table.clear();
  CHECK_FALSE(table.has(std::uint64_t{1} << 40));
}

TEST_CASE("a table of a million keys takes twelve to thirty-two bytes a key") {
  std::mt19937_64 random(1);
  Known known;
  for (Number i = 0; i < 1'000'000; ++i) {
    known.add(random() | 1, i);
    if (i > 10'000 && i % 9'973 == 0) CHECK(known.bytes() <= std::size_t{33} * i);
  }
}

TEST_CASE(
    "a micro-step that was played is known in how many ways, or forgotten for another, also when there is more room") {
  PlayedTable played(1U << 8);
  constexpr std::uint64_t one = 0x1234567890000011, other = 0x9876543210000011;
  CHECK(played.find(one) == 0);
  played.add(one, 3);
  CHECK(played.find(one) == 3);
  CHECK(played.find(other) == 0);
  played.grow(1U << 10);
  CHECK(played.find(one) == 3);
  played.add(other, 255);
  CHECK(played.find(other) == 255);
  CHECK(played.find(one) == 0);
  played.add(one, 256); // more than is written down
  CHECK(played.find(one) == 0);
}
