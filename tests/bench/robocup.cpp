// Header: tests/bench/workload.hpp. Test: tests/bench/workload_test.cpp.
// SPDX-License-Identifier: MIT
//
// behaviours/robocup plays a script: inputs of sensors and a referee, and bodies that alternate between the packs of
// their providers.
#include "tests/bench/table_robot.hpp"
#include "tests/bench/workload.hpp"

namespace bench {

using director::Index;

namespace {

constexpr director::Time tick = 10'000; // us

/// One tick of 10 ms. Sensors post at each, the ball is seen at 33 Hz and the goals at 10 Hz; a half begins with READY
/// and SET, the robot falls every two minutes and stands again four seconds later.
class Robocup final : public Playing {
public:
  Robocup(std::size_t, std::uint64_t, director::Observer observer)
      : robot_(compile_file("behaviours/robocup/robocup.yaml"), 64, Play::changing, observer) {
    robot_.act_length = 64;
    set("Stability", "STANDING");
    set("WalkState", "STOPPED");
    for (const char* root : {"Walk", "Look", "FindPurpose", "FallRecovery"})
      robot_.post(robot_.request(robot_.root(root)));
    robot_.step();
  }

  void take() override {
    const std::uint64_t second = ticks_ / 100;
    if (ticks_ % 100 == 0) every_second(second);
    fire(sensors_);
    if (ticks_ % 3 == 0) fire(ball_);
    if (ticks_ % 10 == 0) fire(goals_);
    robot_.step(static_cast<director::Time>(++ticks_) * tick);
  }

private:
  void every_second(std::uint64_t second) {
    const std::uint64_t in_half = second % 1800;
    if (in_half == 0) set("Phase", "READY");
    if (in_half == 45) set("Phase", "SET");
    if (in_half == 60) set("Phase", "PLAYING");
    if (second % 120 == 100) set("Stability", "FALLEN");
    if (second % 120 == 104) set("Stability", "STANDING");
  }

  void set(const char* name, const char* word) {
    const Index state = robot_.state(name);
    robot_.post({.kind = director::Input::Kind::set, .thing = state, .value = robot_.value(state, word)});
  }
  void fire(Index trigger) { robot_.post({.kind = director::Input::Kind::fire, .thing = trigger}); }

  TableRobot robot_;
  const Index sensors_ = robot_.trigger("Sensors"), ball_ = robot_.trigger("Ball"), goals_ = robot_.trigger("Goals");
  std::uint64_t ticks_ = 0;
};

} // namespace

void add_robocup(std::vector<Workload>& workloads) {
  workloads.push_back({.name = "robocup",
                       .title = "behaviours/robocup: 10 ms of a game by script",
                       .aim = "2,000",
                       .make = play<Robocup>,
                       .inputs = 60'000,
                       .counted = 2'000});
}

} // namespace bench
