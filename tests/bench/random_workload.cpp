// Header: tests/bench/workload.hpp. Test: tests/bench/workload_test.cpp.
// SPDX-License-Identifier: MIT
//
// Random inputs for random behaviours: most set a state, some request a root task or cancel one, few fire a trigger.
#include "tests/bench/random_behaviour.hpp"
#include "tests/bench/table_robot.hpp"
#include "tests/bench/workload.hpp"

#include <array>

namespace bench {

using director::Index;
using director::Input;

namespace {

class AtRandom final : public Playing {
public:
  AtRandom(std::size_t groups, std::uint64_t seed, director::Observer observer)
      : robot_(compile_text(random_behaviour(groups, seed)), 64, Play::at_random, observer),
        random_(seed),
        triggers_{robot_.trigger("Tick"), robot_.trigger("Tock")} {
    for (Index root = 0; root < robot_.model().roots.size(); ++root) robot_.post(robot_.request(root));
    robot_.step();
  }

  void prepare() override {
    const std::uint32_t kind = random_.below(100);
    const Index root = random_.below(robot_.model().roots.size());
    if (kind < 60) {
      input_ = {.kind = Input::Kind::set, .thing = random_.below(robot_.model().states.size())};
      input_.value = static_cast<std::int32_t>(random_.below(4));
    } else if (kind < 85) {
      input_ = robot_.request(root, random_.below(2));
    } else if (kind < 95) {
      input_ = {.kind = Input::Kind::cancel, .thing = root};
    } else {
      input_ = {.kind = Input::Kind::fire, .thing = triggers_[random_.below(2)]};
    }
  }
  void take() override {
    robot_.post(input_);
    robot_.step();
  }

private:
  TableRobot robot_;
  Random random_;
  std::array<Index, 2> triggers_;
  Input input_;
};

} // namespace

void add_random(std::vector<Workload>& workloads) {
  struct Row {
    std::size_t groups, inputs, counted;
    const char* aim;
  };
  for (const Row& row : {Row{20, 10'000, 1'000, "1,000, p99 10,000"}, Row{60, 10'000, 1'000, "2,500, p99 25,000"},
                         Row{200, 5'000, 500, "7,000, p99 70,000"}, Row{400, 2'500, 100, "13,000, p99 130,000"}})
    workloads.push_back({.name = "random/" + std::to_string(row.groups),
                         .title = "random behaviours, groups of one component: " + std::to_string(row.groups),
                         .aim = row.aim,
                         .make = play<AtRandom>,
                         .size = row.groups,
                         .seeds = 4,
                         .inputs = row.inputs,
                         .counted = row.counted});
}

} // namespace bench
