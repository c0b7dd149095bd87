// Header: this program, started by ./bench. Test: tests/bench/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// large_behaviour GROUPS: prints a behaviour with this number of groups.
#include "tests/bench/texts.hpp"

#include <cstdlib>
#include <iostream>

int main(int count, char** arguments) {
  const int groups = count == 2 ? std::atoi(arguments[1]) : 0;
  if (groups < 10) {
    std::cerr << "large_behaviour GROUPS (at least ten)\n";
    return 2;
  }
  std::cout << bench::trees(static_cast<std::size_t>(groups));
  return 0;
}
