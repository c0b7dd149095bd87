#pragma once
// SPDX-License-Identifier: MIT
// Workloads of users: a robot in its world, with inputs that never come in the same order twice. The time of each input
// is measured, to see the worst ones.

#include "tests/bench/tape.hpp"

#include <memory>
#include <string>
#include <vector>

namespace bench {

/// A behaviour that is played; a new one plays the same.
class Playing {
public:
  virtual ~Playing() = default;
  virtual void prepare() {} ///< not measured: the world moves, or the next input is drawn
  virtual void take() = 0;  ///< the input, with the step that takes it
};

struct Workload {
  std::string name;  ///< `random/60`
  std::string title; ///< for the report
  std::string aim;   ///< in ns, of the mean by default; empty: none
  std::unique_ptr<Playing> (*make)(std::size_t size, std::uint64_t seed, director::Observer observer) = nullptr;
  std::size_t size = 0;    ///< groups
  std::size_t seeds = 1;   ///< number of games
  std::size_t inputs = 0;  ///< inputs of each game
  std::size_t counted = 0; ///< inputs of the first game in count_instructions; 0: it takes too long there
};

/// All workloads, in the order of the page.
const std::vector<Workload>& workloads();

// Each is in a file of its own.
void add_soccer(std::vector<Workload>& workloads);
void add_robocup(std::vector<Workload>& workloads);
void add_random(std::vector<Workload>& workloads);
void add_wide(std::vector<Workload>& workloads);
void add_trees(std::vector<Workload>& workloads);

template <class It>
std::unique_ptr<Playing> play(std::size_t size, std::uint64_t seed, director::Observer observer) {
  return std::make_unique<It>(size, seed, observer);
}

/// The calls and writes of the engine for the first inputs.
Tape record(const Workload& workload, std::uint64_t seed, std::size_t inputs);

} // namespace bench
