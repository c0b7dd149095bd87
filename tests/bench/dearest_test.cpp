// SPDX-License-Identifier: MIT
#include "compiler/analysis/plans/work.hpp"
#include "tests/bench/dearest.hpp"
#include "tests/bench/report.hpp"

#include <catch2/catch.hpp>

using namespace bench;

TEST_CASE("no micro-step that random inputs find takes more work than its bound, and some take a good part of it") {
  for (Search search : searches()) {
    INFO(search.name);
    search.seeds = 2;
    search.inputs = search.inputs / 10;
    const Dearest found = find_dearest(search);
    CHECK(found.work > 0);
    CHECK(found.work <= found.work_bound);
    CHECK(found.micro_steps > search.inputs);
    CHECK(found.nanoseconds_bound == static_cast<double>(found.work_bound) * director::analysis::nanoseconds_of_work);
  }
}

TEST_CASE("a random player does the same when it is repeated") {
  for (const Search& search : searches()) {
    INFO(search.name);
    Wanderer first(search.compile(3), 3), again(search.compile(3), 3);
    for (int i = 0; i < 50; ++i) {
      for (Wanderer* each : {&first, &again}) {
        each->post();
        while (each->micro_step()) {}
      }
      CHECK(first.work() == again.work());
    }
  }
}

TEST_CASE("exceeding a bound is a fault, and the table has the shares") {
  const Search search{"dearest/a", "behaviours/a", {}, 1, 1};
  DearestRow row{search, {}, 61};
  row.found = {.micro_steps = 12'345,
               .work = 120,
               .work_bound = 4'800,
               .nanoseconds = 5'000,
               .nanoseconds_bound = 240'000,
               .share = 0.025,
               .nanoseconds_of_work = 41.66};
  CHECK(table(std::vector{row}) ==
        "| dearest micro-step at random | of | work | bound | share | ns | bound | ns a unit | instructions a unit |\n"
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n"
        "| behaviours/a | 12,345 | 120 | 4,800 | 2.5 % | 5,000 | 240,000 | 41.7 | 61 |\n");
  CHECK(faults_of(std::vector{row}).empty());
  row.found.work = 4'801;
  CHECK(faults_of(std::vector{row}) ==
        "dearest/a: a micro-step took 4801 units of work, more than 4800: that is no bound\n");
}

TEST_CASE("observing has a row for each observer, and events that were dropped are a fault") {
  const Observed all{"a recorder", 123'456, 27.56, 0}, few{"a recorder", 123'456, 2, 5};
  CHECK(table(std::vector{all}) ==
        "| observing soccer | events | ns an event |\n| --- | ---: | ---: |\n| a recorder | 123,456 | 27.6 |\n");
  CHECK(faults_of(std::vector{all}).empty());
  CHECK(faults_of(std::vector{few}) == "a recorder: 5 events were dropped, which costs less than to record them\n");
}
