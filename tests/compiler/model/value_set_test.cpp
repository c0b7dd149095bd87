// SPDX-License-Identifier: MIT
#include "compiler/model/value_set.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <limits>

namespace {

using director::compiler::ValueSet;
constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();

ValueSet of(std::initializer_list<std::int64_t> values) {
  ValueSet out;
  for (const std::int64_t v : values) out = out.united(ValueSet::single(v));
  return out;
}

TEST_CASE("neighbours become one interval, in whatever order they come") {
  CHECK(of({3, 1, 2}) == ValueSet::interval(1, 3));
  CHECK(of({1, 3}).intervals().size() == 2);
  CHECK(ValueSet::interval(0, 5).united(ValueSet::interval(2, 9)) == ValueSet::interval(0, 9));
  CHECK(ValueSet::interval(5, 4).empty());
}

TEST_CASE("what comes last is added at the end, and an empty interval is nothing") {
  ValueSet set;
  set.add_last({1, 2});
  set.add_last({3, 3});
  set.add_last({5, 4});
  set.add_last({6, 9});
  set.add_last({7, 8});
  CHECK(set == ValueSet::interval(1, 3).united(ValueSet::interval(6, 9)));
  for (const std::int64_t value : {1, 2, 3, 6, 7, 8, 9}) CHECK(set.contains(value));
  for (const std::int64_t value : {0, 4, 5, 10}) CHECK_FALSE(set.contains(value));
}

TEST_CASE("a set without some values is what remains around them") {
  CHECK(ValueSet::interval(0, 9).without(of({0, 4, 9})) == ValueSet::interval(1, 3).united(ValueSet::interval(5, 8)));
  CHECK(ValueSet::interval(0, 9).without(ValueSet::interval(-5, 20)).empty());
  CHECK(ValueSet::interval(0, 9).without(ValueSet::interval(20, 30)) == ValueSet::interval(0, 9));
  CHECK(ValueSet().without(of({1})).empty());
}

TEST_CASE("what two sets have in common") {
  CHECK(of({1, 3, 5}).intersected(ValueSet::interval(2, 5)) == of({3, 5}));
  CHECK(of({1}).intersected(of({2})).empty());
  CHECK(of({1, 3, 5}).overlaps(of({0, 2, 5, 9})));
  CHECK(of({0, 2, 5, 9}).overlaps(of({1, 3, 5})));
  CHECK_FALSE(of({1, 3, 5}).overlaps(of({0, 2, 4, 6})));
  CHECK_FALSE(of({1}).overlaps(ValueSet()));
  CHECK_FALSE(ValueSet().overlaps(of({1})));
}

TEST_CASE("a domain is cut where a set begins or ends") {
  using Pieces = std::vector<ValueSet::Interval>;
  const ValueSet middle = ValueSet::interval(3, 5), beyond = ValueSet::interval(-4, 20);
  CHECK(pieces_of(0, 9, {}) == Pieces{{0, 9}});
  CHECK(pieces_of(0, 9, {&middle, &beyond}) == Pieces{{0, 2}, {3, 5}, {6, 9}});
  const ValueSet first = of({0}), last = of({5, 9});
  CHECK(pieces_of(0, 9, {&middle, &first, &last}) == Pieces{{0, 0}, {1, 2}, {3, 4}, {5, 5}, {6, 8}, {9, 9}});
  const ValueSet all = ValueSet::interval(least, most);
  CHECK(pieces_of(least, most, {&all}) == Pieces{{least, most}});
}

TEST_CASE("subsets, members and counts") {
  CHECK(of({3, 5}).subset_of(ValueSet::interval(3, 5)));
  CHECK_FALSE(ValueSet::interval(3, 5).subset_of(of({3, 5})));
  CHECK_FALSE(of({3, 9}).subset_of(ValueSet::interval(3, 5)));
  CHECK_FALSE(of({3}).subset_of(ValueSet()));
  CHECK(ValueSet().subset_of(ValueSet()));
  CHECK(of({3, 5}).contains(5));
  CHECK_FALSE(of({3, 5}).contains(4));
  CHECK(of({3, 5}).count() == 2);
  CHECK(ValueSet().count() == 0);
}

TEST_CASE("the largest numbers are numbers like others") {
  const ValueSet all = ValueSet::interval(least, most);
  CHECK(all.count() == most);
  CHECK(all.without(ValueSet::single(most)) == ValueSet::interval(least, most - 1));
  CHECK(all.without(ValueSet::single(least)) == ValueSet::interval(least + 1, most));
  CHECK(all.without(all).empty());
  CHECK(ValueSet::single(most).united(ValueSet::single(least)).intervals().size() == 2);
  CHECK(ValueSet::single(most).united(ValueSet::single(most - 1)) == ValueSet::interval(most - 1, most));
}

} // namespace
