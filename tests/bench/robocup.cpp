// Door: tests/bench/robocup.hpp. Test: tests/bench/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "tests/bench/robocup.hpp"

#include "tests/bench/by_hand.hpp"
#include "tests/bench/table_robot.hpp"

#include <array>
#include <stdexcept>

namespace bench {

using director::Index;

namespace {

constexpr director::Time tick = 10'000; // us

/// One tick of 10 ms. Sensors speak at each, the ball is seen at 33 Hz and the goals at 10 Hz; a half begins with
/// READY and SET, the robot falls every two minutes and stands again four seconds later.
class Robocup {
public:
  Robocup() : robot_(compile_file("behaviours/robocup/robocup.yaml"), 64, Play::changing) {
    robot_.act_length = 64;
    set("Stability", "STANDING");
    set("WalkState", "STOPPED");
    for (const char* root : {"Walk", "Look", "FindPurpose", "FallRecovery"})
      robot_.post(robot_.request(robot_.root(root)));
    robot_.step();
  }

  void once() {
    const std::uint64_t second = ticks_ / 100;
    if (ticks_ % 100 == 0) every_second(second);
    fire(sensors_);
    if (ticks_ % 3 == 0) fire(ball_);
    if (ticks_ % 10 == 0) fire(goals_);
    robot_.step(static_cast<director::Time>(++ticks_) * tick);
  }
  std::uint64_t calls() const { return robot_.calls(); }
  double passes() const {
    return static_cast<double>(robot_.engine().passes()) / static_cast<double>(robot_.engine().micro_steps());
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

void add_robocup(std::vector<Entry>& entries) {
  Entry entry;
  entry.name = "robocup";
  entry.title = "behaviours/robocup: 10 ms of a game by script";
  entry.counted = 2'000;
  entry.director = make<Robocup>;
  entries.push_back(entry);
}

} // namespace bench
