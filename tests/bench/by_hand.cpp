// Header: tests/bench/by_hand.hpp. Test: tests/bench/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "tests/bench/by_hand.hpp"

namespace bench {

namespace {

void provide(Robot& robot, std::size_t self) {
  ++robot.calls;
  robot.requested[self] = 1;
}

void call(Robot& robot, std::size_t provider) { robot.providers[provider](robot, provider); }

} // namespace

Robot build_by_hand(std::size_t count) {
  Robot robot;
  robot.providers.assign(count, provide);
  robot.requested.assign(count, 0);
  robot.holder.assign(count, 0);
  robot.states.assign(count, 0);
  return robot;
}

void take(Robot& robot, Input input, std::size_t which) {
  switch (input) {
  case Input::nothing: break;
  case Input::set: robot.states[0] = static_cast<int>(which); break;
  case Input::again: call(robot, which); break;
  case Input::all:
    for (std::size_t each = 0; each < robot.providers.size(); ++each) call(robot, each);
    break;
  case Input::steal: // 0: left, 1: right, 2: the group that they share
    robot.holder[2] = which;
    call(robot, 0);
    call(robot, 2);
    break;
  case Input::kick: // 0: walking, 1: halting, 2: kick, 3: legs
    call(robot, which + 1);
    robot.states[which] = 1;
    robot.holder[which + 3] = which + 2;
    call(robot, which + 2);
    robot.requested[which + 2] = 0;
    robot.holder[which + 3] = which;
    call(robot, which);
    robot.states[which] = 0;
    call(robot, which + 3);
    break;
  }
}

Idler& idler() {
  class Empty final : public Idler {
    void step() override {}
  };
  static Empty empty;
  return empty;
}

} // namespace bench
