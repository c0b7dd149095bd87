// Header: tests/bench/workload.hpp. Test: tests/bench/workload_test.cpp.
// SPDX-License-Identifier: MIT
//
// Thousands of groups in trees of ten. In each round every tree has one input, in another order.
#include "tests/bench/random_behaviour.hpp"
#include "tests/bench/table_robot.hpp"
#include "tests/bench/texts.hpp"
#include "tests/bench/workload.hpp"

#include <stdexcept>

namespace bench {

namespace {

class Trees final : public Playing {
public:
  Trees(std::size_t groups, std::uint64_t seed, director::Observer observer)
      : robot_(compile_text(trees(groups)), 64, Play::same, observer),
        random_(seed) {
    for (std::size_t i = 1; i <= groups / 10; ++i) {
      const std::string tree = std::to_string(i);
      const director::Index pose = robot_.state("Pose_" + tree);
      for (const auto& [provider, value] : {std::pair{".walking", "moving"}, std::pair{".halting", "standing"}}) {
        Act& act = robot_.act("Walk_" + tree + provider);
        act.state = pose;
        act.value = robot_.value(pose, value);
      }
      robot_.act("Kick_" + tree).answer = director::Outcome::Kind::done;
      kicks_.push_back(robot_.request(robot_.root("Kick_" + tree)));
      robot_.post(robot_.request(robot_.root("Robot_" + tree)));
      robot_.step();
    }
    next_ = kicks_.size();
    const std::uint64_t before = robot_.calls();
    prepare();
    take();
    if (robot_.calls() - before != 4) throw std::logic_error("a kick is one push and one steal");
  }

  void prepare() override {
    if (next_ == kicks_.size()) {
      for (std::size_t i = kicks_.size(); i > 1; --i) std::swap(kicks_[i - 1], kicks_[random_.below(i)]);
      next_ = 0;
    }
  }
  void take() override {
    robot_.post(kicks_[next_++]);
    robot_.step();
  }

private:
  TableRobot robot_;
  Random random_;
  std::vector<director::Input> kicks_; ///< in the order of this round
  std::size_t next_ = 0;
};

} // namespace

void add_trees(std::vector<Workload>& workloads) {
  for (const std::size_t groups : {100U, 1'000U, 10'000U})
    workloads.push_back({.name = "trees/" + std::to_string(groups),
                         .title = "trees of ten groups, a steal and a push in one: " + std::to_string(groups),
                         .aim = "600",
                         .make = play<Trees>,
                         .size = groups,
                         .inputs = 10'000,
                         .counted = 1'000});
}

} // namespace bench
