// SPDX-License-Identifier: MIT
// The layout of the engine's memory.

#include "runtime/core/base/state.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace director::tests {
namespace {

const Shape some{.groups = 5,
                 .providers = 7,
                 .edges = 11,
                 .conditions = 3,
                 .states = 2,
                 .promises = 1,
                 .plan_slots = 4,
                 .listen_slots = 3,
                 .most_edges = 4,
                 .components = 2,
                 .lacking = 6,
                 .pushable = 2,
                 .altered = 4};

TEST_CASE("every array is inside the block, aligned, and behind the one before") {
  std::vector<std::uint64_t> memory(State::bytes(some) / 8);
  State state = State::in(reinterpret_cast<std::byte*>(memory.data()), State::layout(some).begin);
  const auto* at = reinterpret_cast<const std::byte*>(memory.data());
  std::size_t arrays = 0;
  State::each(
      state, some,
      [&]<class T>(T*& array, std::size_t count) {
        const auto* begin = reinterpret_cast<const std::byte*>(array);
        CHECK(begin >= at);
        CHECK(reinterpret_cast<std::uintptr_t>(array) % alignof(T) == 0);
        at = reinterpret_cast<const std::byte*>(array + count);
        ++arrays;
      },
      [] {});
  CHECK(arrays == State::arrays);
  CHECK(state.end == reinterpret_cast<const std::byte*>(memory.data()) + State::bytes(some));
  CHECK(static_cast<std::size_t>(at - reinterpret_cast<const std::byte*>(memory.data())) <= State::bytes(some));
}

TEST_CASE("the decision state is the smaller part, and its size is known at compile time") {
  static_assert(State::decision_bytes(Shape{}) > 0);
  CHECK(State::decision_bytes(some) < State::bytes(some));
  CHECK(State::decision_bytes(some) % 8 == 0);
}

TEST_CASE("the bound of false conditions is the sum over groups of the most of a provider, and causing providers can "
          "be pushed") {
  const std::vector<Provider> providers = [] {
    std::vector<Provider> rows(3);
    rows[0].when = {0, 2};
    rows[1].when = {2, 5};
    rows[2].when = {5, 6};
    rows[1].causing = {0, 1};
    return rows;
  }();
  std::vector<Group> groups(2);
  groups[0].providers = {0, 2};
  groups[1].providers = {2, 3};
  Tables tables;
  tables.providers = providers;
  tables.groups = groups;
  CHECK(Shape::of(tables).lacking == 4);
  CHECK(Shape::of(tables).pushable == 1);
}

TEST_CASE(
    "changed requests are remembered if there are several components: as many as one run, or one input, can change") {
  const std::vector<Component> one(1), several(2);
  Tables tables;
  tables.root_edges = 3;
  tables.most_edges = 2;
  tables.components = one;
  CHECK(Shape::of(tables).altered == 0);
  tables.components = several;
  CHECK(Shape::of(tables).altered == 3);
  tables.most_edges = 5;
  CHECK(Shape::of(tables).altered == 5);
}

} // namespace
} // namespace director::tests
