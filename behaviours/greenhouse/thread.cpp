// Header: none, a program. Test: tests/behaviours/greenhouse/programs_test.cpp, tests/system/threads/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// A second thread reads the sensors, and posts what it reads. It owns a copy of `post()`, and nothing else is shared.
#include "behaviours/greenhouse/house.hpp"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <thread>

namespace {

/// Falls by a per cent a reading. However full the inbox is, the newest one is not refused.
void read_soil(greenhouse::Behaviour::Post post, std::atomic<bool>& running) {
  for (int water = 40; water >= 20; --water) {
    if (!post.set(greenhouse::Soil{water})) std::abort(); // a value that Soil does not have
  }
  running = false;
}

} // namespace

int main() {
  Gardener gardener;
  House house;
  greenhouse::Behaviour behaviour{gardener, house};
  behaviour.request<greenhouse::Garden>();

  std::atomic<bool> running{true};
  std::thread sensor(read_soil, behaviour.post(), std::ref(running));
  const auto start = std::chrono::steady_clock::now();
  const auto turn = [&] { behaviour.step(std::chrono::steady_clock::now() - start); };
  while (running) turn();
  sensor.join();
  turn(); // what was posted last
}
