// SPDX-License-Identifier: MIT
#include "tests/bench/case.hpp"
#include "tests/bench/report.hpp"

#include <catch2/catch.hpp>

using namespace bench;

namespace {

Entry entry(const char* name, const char* title, const char* aim) {
  Entry out;
  out.name = name;
  out.title = title;
  out.aim = aim;
  return out;
}

} // namespace

TEST_CASE("the table shows three digits, the ratio to the floor and the growth of a case") {
  const Entry small = entry("trees/100", "100 groups", ""), large = entry("trees/1000", "1000 groups", "1.5x");
  Row first{small}, second{large};
  first.nanoseconds = 29'312.4;
  first.by_hand = 7.123;
  first.calls = first.calls_by_hand = 4;
  second.nanoseconds = 58'624.8;
  second.grows_from = 29'312.4;
  second.instructions = 1'234'567;
  CHECK(table(std::vector{first, second}) ==
        "| case | median ns | aim | runs | ns by hand | ratio | instructions | allocations | growth |\n"
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |\n"
        "| 100 groups | 29,312 |  | 4 | 7.12 | 4,115 |  | 0 |  |\n"
        "| 1000 groups | 58,625 | 1.5x | 0 |  |  | 1,234,567 | 0 | 2.00x |\n");
}

TEST_CASE("for workloads the table also shows the tail") {
  const Workload it{.name = "random/60", .title = "60 groups", .aim = "2,500"};
  WorkloadRow row{it, {}, 0};
  row.times = {
      .mean = 4'321.4, .p50 = 40, .p99 = 12'000, .p999 = 34'567, .max = 1'000'000, .by_hand = 8.5, .calls = 2.5};
  CHECK(table(std::vector{row}) ==
        "| workload, ns an input | mean | aim | p50 | p99 | p99.9 | max | runs | by hand | instructions |\n"
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n"
        "| 60 groups | 4,321 | 2,500 | 40.0 | 12,000 | 34,567 | 1,000,000 | 2.50 | 8.50 |  |\n");
  CHECK(faults_of(std::vector{row}).empty());
  row.times.heap_uses = 2;
  CHECK(faults_of(std::vector{row}) == "random/60: it allocated 2 times\n");
}

TEST_CASE("an invalid floor, different runs than in the floor, and an allocation are faults") {
  const Entry it = entry("again", "again", "");
  Row slow{it}, other{it}, allocating{it}, fine{it};
  slow.by_hand = 21;
  slow.calls = slow.calls_by_hand = 4;
  other.by_hand = 1;
  other.calls = 2;
  other.calls_by_hand = 1;
  allocating.heap_uses = 3;
  fine.by_hand = 20;
  fine.calls = fine.calls_by_hand = 4;
  CHECK(faults_of(std::vector{slow, other, allocating, fine}) ==
        "again: by hand it takes 5.25 ns a run, more than 5.00: it is no floor\n"
        "again: 2.00 runs, and by hand 1.00\n"
        "again: it allocated 3 times\n");
}

TEST_CASE("each case and its floor call as many providers") {
  for (const Entry& each : entries()) {
    if (each.by_hand == nullptr || each.size > 100) continue;
    const std::unique_ptr<Case> director = each.director(each.size), by_hand = each.by_hand(each.size);
    const std::uint64_t before = director->calls();
    director->run(10);
    by_hand->run(10);
    INFO(each.name);
    CHECK(director->calls() - before == by_hand->calls());
  }
}
