#pragma once
// SPDX-License-Identifier: MIT
// The most expensive micro-step that random inputs find, and the bound that `directorc check --verbose` prints.

#include "tests/bench/random_behaviour.hpp"
#include "tests/bench/table_robot.hpp"

#include <functional>
#include <string>
#include <vector>

namespace bench {

struct Search {
  std::string name;  ///< `dearest/soccer`
  std::string title; ///< for the report
  std::function<Compiled(std::uint64_t seed)> compile;
  std::size_t seeds = 1;  ///< number of behaviours, or of ways to play one
  std::size_t inputs = 0; ///< inputs of each
};

/// All of them, in the order of the page.
const std::vector<Search>& searches();

/// Plays a behaviour at random: most inputs set a state, some request a root task or cancel one, few fire a trigger,
/// disable a provider or enable one, and before each a little time passes.
class Wanderer {
public:
  Wanderer(Compiled compiled, std::uint64_t seed);
  void post();       ///< the next input
  bool micro_step(); ///< false: it is at rest
  std::uint64_t work() const { return robot_.engine().work(); }

private:
  director::Input draw();

  TableRobot robot_;
  Random random_;
  director::Time now_ = 0;
  std::vector<director::Index> externals_, roots_, triggers_;
};

struct Dearest {
  std::uint64_t micro_steps = 0;
  std::uint64_t work = 0;       ///< the most of one micro-step
  std::uint64_t work_bound = 0; ///< its bound
  double nanoseconds = 0;       ///< the most of one micro-step, the least of all replays
  double nanoseconds_bound = 0; ///< the bound of the behaviour with the largest share, from the time of a unit of work
  double share = 0;             ///< of the work, relative to the bound of the same behaviour
  double nanoseconds_of_work = 0; ///< of a unit of work, in micro-steps with some work
};
Dearest find_dearest(const Search& search);

} // namespace bench
