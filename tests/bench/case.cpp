// Header: tests/bench/case.hpp. Test: tests/bench/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "tests/bench/case.hpp"

#include "tests/bench/grown_cases.hpp"
#include "tests/bench/small_cases.hpp"

namespace bench {

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> out;
    add_small_cases(out);
    add_grown_cases(out);
    return out;
  }();
  return all;
}

} // namespace bench
