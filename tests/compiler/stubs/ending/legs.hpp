#pragma once
// SPDX-License-Identifier: MIT
// The module that the generated main program of this behaviour instantiates; it prints its calls.

#include "ending.hpp"

#include <cstdio>

class Legs final : public ending::Legs {
public:
  director::Outcome provide(ending::Walk::Default& run) override {
    std::puts("walks");
    std::fflush(stdout); // the test that waits for it ends the program
    return run.keep();
  }
  void stop(ending::Walk::Stop&) override { std::puts("stops"); }
};
