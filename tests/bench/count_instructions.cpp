// Header: this program. Test: tests/bench/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// Under callgrind: runs each workload and each case several times, and lets callgrind write the cost of each to a file
// of its own. Prints the name and the repetitions of each, in the order of these files.
#include "tests/bench/case.hpp"
#include "tests/bench/dearest.hpp"
#include "tests/bench/workload.hpp"

#include <valgrind/callgrind.h>

#include <algorithm>
#include <iostream>

namespace {

template <class Do>
void count(const std::string& name, std::size_t times, Do&& do_all) {
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_ZERO_STATS;
  do_all();
  CALLGRIND_DUMP_STATS_AT(name.c_str());
  CALLGRIND_STOP_INSTRUMENTATION;
  std::cout << name << " " << times << std::endl;
}

void count(const std::string& name, bench::Case& it, std::size_t times) {
  it.run(std::min<std::size_t>(times, 100)); // work that is done only once is done by now
  count(name, times, [&] { it.run(times); });
}

/// Instructions for each unit of work: those of micro-steps that decide nothing are spread over the others.
void count(const bench::Search& search) {
  constexpr std::size_t inputs = 300;
  bench::Wanderer wanderer(search.compile(1), 1);
  std::uint64_t work = 0;
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_ZERO_STATS;
  for (std::size_t i = 0; i < inputs; ++i) {
    CALLGRIND_TOGGLE_COLLECT;
    wanderer.post();
    const std::uint64_t before = wanderer.work();
    CALLGRIND_TOGGLE_COLLECT;
    while (wanderer.micro_step()) {}
    work += wanderer.work() - before;
  }
  CALLGRIND_DUMP_STATS_AT(search.name.c_str());
  CALLGRIND_STOP_INSTRUMENTATION;
  std::cout << search.name << " " << work << std::endl;
}

void count(const bench::Workload& workload) {
  if (workload.counted == 0) return;
  const std::unique_ptr<bench::Playing> playing = workload.make(workload.size, 1, {});
  count(workload.name, workload.counted, [&] {
    for (std::size_t i = 0; i < workload.counted; ++i) {
      CALLGRIND_TOGGLE_COLLECT;
      playing->prepare();
      CALLGRIND_TOGGLE_COLLECT;
      playing->take();
    }
  });
}

} // namespace

int main() {
  for (const bench::Workload& each : bench::workloads()) count(each);
  for (const bench::Entry& entry : bench::entries()) {
    if (entry.counted == 0) continue;
    count(entry.name, *entry.director(entry.size), entry.counted);
    if (entry.by_hand != nullptr) count(entry.name + ":by_hand", *entry.by_hand(entry.size), entry.counted);
  }
  for (const bench::Search& each : bench::searches()) count(each);
  return 0;
}
