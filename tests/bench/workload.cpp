// Header: tests/bench/workload.hpp. Test: tests/bench/workload_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/bench/workload.hpp"

namespace bench {

const std::vector<Workload>& workloads() {
  static const std::vector<Workload> all = [] {
    std::vector<Workload> out;
    add_soccer(out);
    add_robocup(out);
    add_random(out);
    add_wide(out);
    add_trees(out);
    return out;
  }();
  return all;
}

Tape record(const Workload& workload, std::uint64_t seed, std::size_t inputs) {
  Tape tape;
  const std::unique_ptr<Playing> playing = workload.make(workload.size, seed, tape.observer());
  tape.begin();
  for (std::size_t i = 0; i < inputs; ++i) {
    playing->prepare();
    playing->take();
    tape.end_input();
  }
  return tape;
}

} // namespace bench
