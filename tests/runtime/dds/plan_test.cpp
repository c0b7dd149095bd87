// SPDX-License-Identifier: MIT
#include "runtime/dds/plan.hpp"
#include "tests/runtime/dds/robot.hpp"

#include <catch2/catch.hpp>

using namespace director;
using namespace director::tests;
using dds::Settings;

namespace {

std::string failure(const Settings& settings) {
  Office office;
  try {
    dds::resolve(settings, plug(office.behaviour));
  } catch (const dds::Failure& failure) { return failure.what(); }
  return "";
}

} // namespace

TEST_CASE("names become rows, and values keep their names") {
  Office office;
  const dds::Plan plan =
      dds::resolve(Settings{.robot = "one",
                            .publish = {"Door", "Battery"},
                            .take_in = {{.robot = "two", .state = "Temper", .into = "Mood"},
                                        {.robot = "two", .state = "Charge", .into = "Battery", .behaviour = "arm"}},
                            .offer = {{.task = "Rest"}}},
                   plug(office.behaviour));
  CHECK(plan.published == std::vector<Index>{state_row("Door"), state_row("Battery")});
  const dds::Taken& mood = plan.taken.at({"two", "courier", "Temper"}).front();
  CHECK(mood.state == state_row("Mood"));
  CHECK(dds::number_of(mood, "hurried") == 1);
  CHECK(dds::number_of(mood, "merry") == std::nullopt);
  CHECK(dds::number_of(mood, 1) == std::nullopt);
  const dds::Taken& battery = plan.taken.at({"two", "arm", "Charge"}).front();
  CHECK(dds::number_of(battery, 100) == 100);
  CHECK(dds::number_of(battery, 101) == std::nullopt);
  CHECK(dds::number_of(battery, "full") == std::nullopt);
  CHECK(plan.offered.contains("Rest"));
}

TEST_CASE("every mistake in the settings is reported") {
  CHECK(failure({.robot = "one",
                 .publish = {"Dor"},
                 .take_in = {{.robot = "two", .state = "Door", .into = "Door"},
                             {.robot = "one", .state = "Mood", .into = "Mood"}},
                 .offer = {{.task = "Sleep"}, {.task = "Deliver"}}}) ==
        "dds: the behaviour courier has no state Dor; it has Mood, Door, Battery\n"
        "dds: the state Door is not external, so nothing from outside can become its value\n"
        "dds: the state Mood is to be taken in from this robot itself\n"
        "dds: the behaviour courier has no root task Sleep; it has Deliver, Rest\n"
        "dds: the task Deliver carries data, so its offer needs a function that reads them");
  CHECK(failure({.robot = "", .say_again = 0ms}) == "dds: the robot needs a name\ndds: say_again must be above 0");
  CHECK(failure({.robot = "one", .say_again = std::chrono::milliseconds::max()}) ==
        "dds: say_again must be a day at most");
  CHECK(failure({.robot = std::string(256, 'r')}) ==
        "dds: the robot's name is longer than 255 bytes, so nobody would hear it");
  CHECK(failure({.robot = "one",
                 .take_in = {{.robot = "", .state = "Mood", .into = "Mood"},
                             {.robot = "two", .state = "", .into = "Mood"},
                             {.robot = "two", .state = std::string(256, 's'), .into = "Mood"}}}) ==
        "dds: what is taken into the state Mood needs the name of a robot and of its state\n"
        "dds: what is taken into the state Mood needs the name of a robot and of its state\n"
        "dds: what is taken into the state Mood has a name of more than 255 bytes, under which nobody is heard");
  CHECK(failure({.robot = "one", .offer = {{.task = "Rest"}, {.task = "Rest"}}}) ==
        "dds: the task Rest is offered twice");
}

TEST_CASE("a specification is identified by the fingerprint of the behaviour and the ranges of its states") {
  Office office;
  const dds::Plug as_it_is = plug(office.behaviour);
  const std::string specification = dds::specification_of(as_it_is);
  CHECK(specification.size() == 16);
  Office another;
  CHECK(dds::specification_of(plug(another.behaviour)) == specification);
  dds::Plug other = as_it_is;
  ++other.fingerprint;
  CHECK(dds::specification_of(other) != specification);
  dds::Plug wider = as_it_is;
  std::vector<Domain> domains(as_it_is.domains.begin(), as_it_is.domains.end());
  domains[state_row("Battery")].high = 101;
  wider.domains = domains;
  CHECK(dds::specification_of(wider) != specification);
}
