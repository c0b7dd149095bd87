// Header: none, a program. Test: tests/behaviours/greenhouse/programs_test.cpp.
// SPDX-License-Identifier: MIT
//
// The bare loop: read the sensors, step, and again. Time is the program's own; here a second passes in each turn.
#include "behaviours/greenhouse/house.hpp"

#include <chrono>

namespace {

struct Reading {
  greenhouse::Air air;
  int water; ///< per cent
};

constexpr Reading day[] = {
    {greenhouse::Air::mild, 50}, {greenhouse::Air::mild, 29}, {greenhouse::Air::hot, 28},
    {greenhouse::Air::hot, 31},  {greenhouse::Air::mild, 33},
};

} // namespace

int main() {
  Gardener gardener;
  House house;
  greenhouse::Behaviour behaviour{gardener, house};

  behaviour.request<greenhouse::Garden>();
  std::chrono::seconds now{0};
  for (const Reading& reading : day) {
    if (!behaviour.set(reading.air, greenhouse::Soil{reading.water})) return 1; // both at once, or none
    behaviour.step(now += std::chrono::seconds{1});
  }
}
