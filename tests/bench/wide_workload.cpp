// Header: tests/bench/workload.hpp. Test: tests/bench/workload_test.cpp.
// SPDX-License-Identifier: MIT
//
// Units with many alternatives that all fail: the last member of each needs a group that a stronger task holds.
#include "tests/bench/random_behaviour.hpp"
#include "tests/bench/table_robot.hpp"
#include "tests/bench/texts.hpp"
#include "tests/bench/workload.hpp"

namespace bench {

namespace {

class Wide final : public Playing {
public:
  Wide(std::size_t units, std::uint64_t seed, director::Observer observer)
      : robot_(compile_text(wide_units(units)), 64, Play::same, observer),
        random_(seed),
        requested_(units) {
    robot_.post(robot_.request(robot_.root("Holder")));
    robot_.step();
    for (; unit_ < units; ++unit_) {
      units_.push_back(robot_.request(robot_.root("Unit_" + std::to_string(unit_ + 1))));
      take();
    }
  }
  void prepare() override { unit_ = random_.below(units_.size()); }
  /// Requests or cancels a unit.
  void take() override {
    director::Input input = units_[unit_];
    requested_[unit_] = !requested_[unit_];
    if (!requested_[unit_]) input.kind = director::Input::Kind::cancel;
    robot_.post(input);
    robot_.step();
  }

private:
  TableRobot robot_;
  Random random_;
  std::vector<director::Input> units_;
  std::size_t unit_ = 0; ///< the unit of this input
  std::vector<bool> requested_;
};

} // namespace

void add_wide(std::vector<Workload>& workloads) {
  workloads.push_back({.name = "wide",
                       .title = "50 units of 4 members with 10 providers each, all in vain",
                       .aim = "100,000",
                       .make = play<Wide>,
                       .size = 50,
                       .inputs = 1'000,
                       .counted = 100});
}

} // namespace bench
