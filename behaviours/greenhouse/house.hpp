#pragma once
// SPDX-License-Identifier: MIT
// Shape: the two modules of the greenhouse. What a real one would do with motors, this one prints.

#include "greenhouse.hpp"

#include <cstdio>

class Gardener : public greenhouse::Gardener {
public:
  director::Outcome provide(greenhouse::Storm::Default& run) override { return run.request(greenhouse::Roof{0}); }
  director::Outcome provide(greenhouse::Garden::Default& run) override {
    return run.day(greenhouse::Airing{}, greenhouse::Watering{});
  }
  director::Outcome provide(greenhouse::Airing::Opening& run) override { return run.request(greenhouse::Roof{60}); }
  director::Outcome provide(greenhouse::Watering::Pouring& run) override { return run.request(greenhouse::Pump{}); }
  director::Outcome provide(greenhouse::Airing::Resting& run) override { return run.request(); }
  director::Outcome provide(greenhouse::Watering::Resting& run) override { return run.request(); }
};

class House final : public greenhouse::House {
public:
  director::Outcome provide(greenhouse::Roof::Default& run) override {
    std::printf("roof %d%%\n", run.task());
    return run.keep();
  }
  void stop(greenhouse::Roof::Stop&) override { std::puts("roof 0%, nobody needs it open"); }
  director::Outcome provide(greenhouse::Pump::Default& run) override { return run.keep(); }
  void start(greenhouse::Pump::Start&) override { std::puts("pump on"); }
  void stop(greenhouse::Pump::Stop&) override { std::puts("pump off"); }
};
