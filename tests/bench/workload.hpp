#pragma once
// SPDX-License-Identifier: MIT
// What users do: a robot in its world, and inputs that never come in the same order twice. The time of each input is
// taken, so that the worst ones are seen.

#include "tests/bench/tape.hpp"

#include <memory>
#include <string>
#include <vector>

namespace bench {

/// A behaviour that is played; the same again if it is made again.
class Playing {
public:
  virtual ~Playing() = default;
  virtual void prepare() {} ///< what is not measured: the world moves, or the next input is drawn
  virtual void take() = 0;  ///< the input, with the step that takes it
};

struct Workload {
  std::string name;  ///< `random/60`
  std::string title; ///< for people
  std::string aim;   ///< in ns, of the mean if nothing else is said; empty: none
  std::unique_ptr<Playing> (*make)(std::size_t size, std::uint64_t seed, director::Observer observer) = nullptr;
  std::size_t size = 0;    ///< groups
  std::size_t seeds = 1;   ///< so many are played, one after the other,
  std::size_t inputs = 0;  ///< each so long
  std::size_t counted = 0; ///< inputs of the first one that count_instructions takes; 0: it takes too long there
};

/// In the order of the page.
const std::vector<Workload>& workloads();

// Each in a file of its own.
void add_soccer(std::vector<Workload>& workloads);
void add_robocup(std::vector<Workload>& workloads);
void add_random(std::vector<Workload>& workloads);
void add_wide(std::vector<Workload>& workloads);
void add_trees(std::vector<Workload>& workloads);

template <class It>
std::unique_ptr<Playing> play(std::size_t size, std::uint64_t seed, director::Observer observer) {
  return std::make_unique<It>(size, seed, observer);
}

/// What the engine called and wrote for the first inputs.
Tape record(const Workload& workload, std::uint64_t seed, std::size_t inputs);

} // namespace bench
