// Header: tests/defects/gadgets.hpp. Test: tests/defects/measure.cpp.
// SPDX-License-Identifier: MIT
#include "tests/defects/gadgets.hpp"

namespace director::defects {

std::string make(Robot& robot, std::string_view text, const std::vector<std::string>& words) {
  std::string name = robot.verb();
  robot.add_group(name, text, words);
  return name;
}

std::string make_root(Robot& robot, std::string_view text, const std::vector<std::string>& words) {
  std::string name = make(robot, text, words);
  robot.add_root(name, robot.above());
  return name;
}

void ask_for_both(Robot& robot, const std::string& first, const std::string& second) {
  const std::size_t way = robot.r.below(3);
  if (way == 0) {
    robot.add_root(second, robot.above());
    robot.add_root(first, robot.above());
  } else if (way == 1) {
    make_root(robot, "{packs: {go: {$0: {priority: 20}, $1: {priority: 10, apart: true}}}}", {first, second});
  } else {
    const std::string between = make(robot, "{packs: {do_it: {$0: {}}}}", {first});
    make_root(robot, "{packs: {go: {$0: {priority: 20}, $1: {priority: 10, apart: true}}}}", {between, second});
  }
}

std::string make_state(Robot& robot, const std::string& first, const std::string& second) {
  const std::string name = robot.name(robot.r.one_of({"Grip", "Gate", "Shape", "Tilt", "Height", "Focus"}));
  robot.add_state(name, "{values: [$0, $1], initial: $0}", {first, second});
  return name;
}

std::string causer(Robot& robot, const std::string& state, const std::string& value, const std::string& before) {
  return make(robot, "{providers: [{name: going, sets: [$0 == $2]}, {name: coming, causing: [$0 == $1]}]}",
              {state, value, before});
}

} // namespace director::defects
