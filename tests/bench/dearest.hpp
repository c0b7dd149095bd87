#pragma once
// SPDX-License-Identifier: MIT
// The dearest micro-step that random inputs find, beside what `directorc check --verbose` says that none exceeds.

#include "tests/bench/random_behaviour.hpp"
#include "tests/bench/table_robot.hpp"

#include <functional>
#include <string>
#include <vector>

namespace bench {

struct Search {
  std::string name;  ///< `dearest/soccer`
  std::string title; ///< for people
  std::function<Compiled(std::uint64_t seed)> compile;
  std::size_t seeds = 1;  ///< so many behaviours, or ways to play one,
  std::size_t inputs = 0; ///< with so many inputs each
};

/// In the order of the page.
const std::vector<Search>& searches();

/// One behaviour at random: of the inputs most set a state, some request a root task or cancel one, few fire a trigger,
/// disable a provider or enable one, and before each a little time passes.
class Wanderer {
public:
  Wanderer(Compiled compiled, std::uint64_t seed);
  void post();       ///< the next input
  bool micro_step(); ///< false: it rests
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
  std::uint64_t work = 0;       ///< the most that one took
  std::uint64_t work_bound = 0; ///< what none exceeds
  double nanoseconds = 0;       ///< the most that one took, the least of all replays
  double nanoseconds_bound =
      0;            ///< the bound of that behaviour whose share is the largest, at what a unit is taken to cost
  double share = 0; ///< of the work, against the bound of the same behaviour
  double nanoseconds_of_work = 0; ///< of a unit, in those that take some
};
Dearest find_dearest(const Search& search);

} // namespace bench
