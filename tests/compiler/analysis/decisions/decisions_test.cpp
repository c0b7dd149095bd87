// SPDX-License-Identifier: MIT
// Tests how much is examined, and the containers of moments. That the decisions are true:
// tests/property/decisions_test.cpp.
#include "compiler/analysis/decisions/decisions.hpp"
#include "compiler/analysis/decisions/few.hpp"
#include "compiler/analysis/decisions/seen.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <vector>

namespace {

using director::analysis::bit;
using director::analysis::Decisions;
using director::analysis::each;
using director::analysis::Few;
using director::analysis::Seen;

TEST_CASE("a file of one group more has hardly fewer steps to decide in, and one of very many has some") {
  CHECK(Decisions::steps_for(1) == Decisions::most_steps);
  CHECK(Decisions::steps_for(100) == Decisions::most_steps);
  for (std::size_t groups = 1; groups < 3'000; ++groups) {
    const auto here = Decisions::steps_for(groups), next = Decisions::steps_for(groups + 1);
    if (next > here || next * 100 < here * 99) FAIL("from " << groups << " groups on: " << here << ", then " << next);
  }
  CHECK(Decisions::steps_for(10'000) == Decisions::most_steps / 18);
}

TEST_CASE("a value is seen once, however many there are, and after clear() it was not") {
  using Value = std::array<std::uint16_t, 5>; // no multiple of a word
  Seen<Value> seen;
  for (int round = 0; round < 2; ++round) {
    std::size_t added = 0;
    for (std::uint16_t i = 0; i < 1'000; ++i) added += seen.add({7, 7, 7, 7, i}) ? 1U : 0U;
    CHECK(added == 1'000);
    CHECK(seen.size() == 1'000);
    for (std::uint16_t i = 0; i < 1'000; ++i) added += seen.add({7, 7, 7, 7, i}) ? 1U : 0U;
    CHECK(added == 1'000);
    seen.clear();
    CHECK(seen.size() == 0);
  }
}

TEST_CASE("few values keep their order, and compare one by one") {
  Few<int, 4> few{5, 6};
  few.push_back(7);
  few.push_back(8);
  few.erase(few.begin() + 1);
  CHECK(std::vector<int>(few.begin(), few.end()) == std::vector<int>{5, 7, 8});
  CHECK(few.front() == 5);
  CHECK(few.back() == 8);
  CHECK((Few<int, 4>{5, 7}) < few);
  CHECK_FALSE(few < Few<int, 4>{5, 7});
  CHECK(few < Few<int, 4>{6});
  few.clear();
  CHECK(few.empty());
}

TEST_CASE("the rows of a set come in order") {
  std::vector<int> rows;
  for (const auto row : each(bit(63) | bit(0) | bit(7))) rows.push_back(row);
  CHECK(rows == std::vector<int>{0, 7, 63});
  for (const auto row : each(0)) rows.push_back(row);
  CHECK(rows.size() == 3);
}

} // namespace
