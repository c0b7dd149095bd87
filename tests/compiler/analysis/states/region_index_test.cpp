// SPDX-License-Identifier: MIT
#include "compiler/analysis/states/region_index.hpp"

#include <catch2/catch.hpp>

#include <random>

namespace {

using namespace director::analysis;

using Places = std::vector<std::size_t>;

constexpr StateId x{0}, y{1};

Region region(ValueSet of_x) {
  Region out;
  out.meet(x, of_x);
  return out;
}

Places meeting(const RegionIndex& index, const Region& asked, std::size_t end) {
  Places out;
  index.visit_meeting(asked, end, [&](std::size_t place) {
    out.push_back(place);
    return true;
  });
  return out;
}

TEST_CASE("of many regions those that meet another one are found") {
  std::vector<Region> regions;
  for (std::int64_t i = 0; i < 100; ++i) regions.push_back(region(ValueSet::single(i)));
  regions.push_back(region(ValueSet::interval(10, 20).united(ValueSet::single(50))));
  regions.push_back({});
  const RegionIndex index(regions);
  CHECK(meeting(index, region(ValueSet::single(7)), 102) == Places{7, 101});
  CHECK(meeting(index, region(ValueSet::single(15)), 102) == Places{15, 100, 101});
  CHECK(meeting(index, region(ValueSet::interval(49, 51)), 102) == Places{49, 50, 51, 100, 101});
  CHECK(meeting(index, region(ValueSet::interval(49, 51)), 51) == Places{49, 50});
  CHECK(meeting(index, region({}), 102) == Places{101});
  CHECK(meeting(index, {}, 3) == Places{0, 1, 2});
}

TEST_CASE("a visit of regions ends with the first one that is enough") {
  std::vector<Region> regions;
  for (std::int64_t i = 0; i < 100; ++i) regions.push_back(region(ValueSet::single(i % 10)));
  const RegionIndex index(regions);
  for (const Region& asked : {Region{}, region(ValueSet::single(3))}) {
    Places visited;
    index.visit_meeting(asked, 100, [&](std::size_t place) {
      visited.push_back(place);
      return place < 13;
    });
    CHECK(visited.back() == 13);
  }
}

TEST_CASE("the index finds the same as a test of each region") {
  std::mt19937 random(1);
  const auto pick = [&](std::int64_t most) {
    return static_cast<std::int64_t>(random() % static_cast<unsigned>(most));
  };
  const auto some = [&] {
    Region out;
    for (const StateId state : {x, y}) {
      if (pick(3) == 0) continue;
      ValueSet values;
      for (std::int64_t n = pick(4); n > 0; --n) {
        const std::int64_t low = pick(30);
        values = values.united(ValueSet::interval(low, low + pick(6)));
      }
      out.meet(state, values);
    }
    return out;
  };
  for (int round = 0; round < 100; ++round) {
    std::vector<Region> regions;
    for (std::int64_t n = pick(60); n > 0; --n) regions.push_back(some());
    const RegionIndex index(regions);
    const Region asked = some();
    Places expected;
    for (std::size_t place = 0; place < regions.size(); ++place) {
      if (compatible(asked, regions[place])) expected.push_back(place);
    }
    CHECK(meeting(index, asked, regions.size()) == expected);
  }
}

} // namespace
