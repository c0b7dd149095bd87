// SPDX-License-Identifier: MIT
#include "compiler/explore/search/frontier.hpp"

#include <catch2/catch.hpp>

#include <numeric>

using namespace director::compiler;

namespace {

/// A state that contains its number.
Packed state_of(std::uint32_t number) {
  Packed out(number % 300);
  std::iota(out.begin(), out.end(), static_cast<std::uint8_t>(number));
  return out;
}

bool is(const Waiting& waiting, std::uint32_t number) {
  const Packed state = state_of(number);
  return waiting.watch == std::uint64_t{number} << 32 && waiting.roots == number &&
         std::equal(state.begin(), state.end(), waiting.state.begin(), waiting.state.end());
}

} // namespace

TEST_CASE("states come out of the frontier in the order in which they went in, while others go in") {
  Frontier frontier;
  std::vector<Waiting> taken;
  std::uint32_t in = 0, out = 0;
  const auto push = [&](std::uint32_t count) {
    for (; count != 0; --count, ++in) frontier.push({state_of(in), std::uint64_t{in} << 32, in});
  };
  push(1);
  while (out < 200'000) {
    frontier.first(1'000, taken);
    REQUIRE(taken.size() == std::min<std::size_t>(1'000, in - out));
    if (in < 150'000) push(2'500);
    for (std::uint32_t i = 0; i < taken.size(); ++i) REQUIRE(is(taken[i], out + i)); // also after others were added
    frontier.drop(taken.size());
    out += static_cast<std::uint32_t>(taken.size());
    REQUIRE(frontier.size() == in - out);
    if (frontier.empty()) break;
  }
  CHECK(out == in);
  CHECK(frontier.empty());
}

TEST_CASE("the frontier uses again what was dropped, and keeps few states in little") {
  Frontier frontier;
  CHECK(frontier.bytes() == 0);
  const Packed state(100);
  frontier.push({state, 0, 0});
  CHECK(frontier.bytes() <= 1U << 14);
  for (int i = 0; i < 1'000'000; ++i) {
    frontier.push({state, 0, 0});
    frontier.drop(1);
  }
  CHECK(frontier.size() == 1);
  CHECK(frontier.bytes() <= 1U << 17);
}

TEST_CASE("a state that is larger than a chunk finds its place") {
  Frontier frontier;
  const Packed small(10, 1), large(50'000, 2);
  frontier.push({small, 0, 0});
  frontier.push({large, 0, 0});
  frontier.push({small, 0, 0});
  std::vector<Waiting> taken;
  frontier.first(9, taken);
  REQUIRE(taken.size() == 3);
  CHECK(taken[0].state.size() == 10);
  CHECK(taken[1].state.size() == 50'000);
  CHECK(taken[2].state.back() == 1);
}
