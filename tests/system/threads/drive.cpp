// Header: tests/system/threads/CMakeLists.txt. Test: itself.
// SPDX-License-Identifier: MIT
//
// The random programs of tests/system/api/drive.hpp while other threads post to both behaviours and read a snapshot.
// Built with the thread sanitizer, which ends the program with an error at a data race.
#include "tests/system/api/drive.hpp"

#include <cstdio>
#include <cstdlib>
#include <thread>

namespace {

using namespace director::tests;

constexpr int others = 3, turns = 150;

std::string drive(std::uint64_t seed) {
  Drive drive(seed, false);
  std::atomic<bool> over{false}, torn{false};
  std::thread threads[others];
  for (int i = 0; i < others; ++i) {
    threads[i] = std::thread([&, i] {
      director::property::Random random(seed * others + static_cast<std::uint64_t>(i) + 1'000'000);
      while (!over) {
        if (drive.disturb(random)) torn = true;
      }
    });
  }
  drive.go_on(turns);
  over = true;
  for (std::thread& thread : threads) thread.join();
  drive.end();
  return torn ? "a snapshot is not of one moment" : drive.wrong();
}

} // namespace

int main(int count, char** arguments) {
  const std::uint64_t seeds = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 40;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const std::string wrong = drive(seed);
    if (wrong.empty()) continue;
    std::fprintf(stderr, "drive: seed %d: %s\n", static_cast<int>(seed), wrong.c_str());
    return 1;
  }
  return 0;
}
