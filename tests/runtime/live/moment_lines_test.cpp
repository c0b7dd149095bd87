// SPDX-License-Identifier: MIT
// Tests runtime/live/moment_lines.hpp, and runtime/hosted/why_notes.hpp with compiled names.
#include "runtime/live/moment_lines.hpp"
#include "tests/system/api/office.hpp"

#include <catch2/catch.hpp>

using namespace director;
using namespace director::tests;
using namespace std::chrono_literals;

namespace {

/// Deliver waits for the door, which is shut.
struct Shut {
  Shut() {
    plans.deliver = [](courier::Deliver::Default& run) { return run.enter(courier::Open{}, courier::Walk{{}}); };
    plans.rest = [](courier::Rest::Default& run) { return run.request(courier::Walk{{}}, courier::Sing{}); };
    behaviour.request<courier::Rest>();
    behaviour.step(1ms);
    behaviour.request(courier::Deliver{{}});
    (void)behaviour.enable<courier::Open::Unlocking>(false);
    (void)behaviour.set(courier::Battery{7});
    behaviour.step(2ms);
  }
  std::string moment() const {
    std::string out;
    live::append_moment(behaviour.seen().view(), courier::names::all(), out);
    return out;
  }
  std::string standing() const {
    std::string out;
    live::append_standing(behaviour.seen().view(), courier::names::all(), out);
    return out;
  }
  std::string why(Index group) const {
    std::string out;
    live::append_why(behaviour.seen().view(), group, courier::names::all(), out);
    return out;
  }
  Plans plans;
  Skills skills;
  courier::Behaviour behaviour{plans, skills};
};

} // namespace

TEST_CASE("a moment is written as the events that lead to it") {
  const Shut waiting;
  CHECK(waiting.moment() == R"({"t":2000,"n":8,"event":"given","state":"Mood","value":"calm"}
{"t":2000,"n":8,"event":"given","state":"Door","value":"shut"}
{"t":2000,"n":8,"event":"given","state":"Battery","value":7}
{"t":2000,"n":8,"event":"input","input":"disable","group":"Open","provider":"unlocking"}
{"t":2000,"n":8,"event":"grant","edge":"root>Deliver","provider":"default"}
{"t":2000,"n":8,"event":"grant","edge":"root>Rest","provider":"default"}
{"t":2000,"n":8,"event":"grant","edge":"Rest>Walk","provider":"default"}
{"t":2000,"n":8,"event":"lose","group":"Open"}
{"t":2000,"n":8,"event":"grant","edge":"Rest>Sing","provider":"default"}
{"t":2000,"n":8,"event":"queue","edge":"Deliver>Walk","why":"waiting","condition":"Door == open"}
{"t":2000,"n":8,"event":"queue","edge":"Deliver>Open","why":"waiting","condition":"Door == open"}
)");
}

TEST_CASE("groups that do not simply run are listed without events") {
  const Shut waiting;
  CHECK(
      waiting.standing() ==
      R"([{"event":"waits","edge":"Deliver>Walk","why":"waiting","condition":"Door == open"},{"event":"waits","edge":"Deliver>Open","why":"waiting","condition":"Door == open"}])");
  Plans plans;
  Skills skills;
  const courier::Behaviour idle{plans, skills};
  std::string nothing;
  live::append_standing(idle.seen().view(), courier::names::all(), nothing);
  CHECK(nothing == "[]");
}

TEST_CASE("the answer of why also has the held group that a group needs") {
  Shut carrying;
  carrying.plans.deliver = [](courier::Deliver::Default& run) { return run.carry(courier::Walk{{}}); };
  (void)carrying.behaviour.fire<courier::Bell>();
  carrying.behaviour.step(3ms);
  Index row = 0;
  while (courier::names::group(row) != std::string_view("Sing")) ++row;
  CHECK(
      carrying.why(row) ==
      R"json({"group":"Sing","kind":"lost","text":"Sing waits (Rest>Sing): it comes with Rest>Walk, and Walk is held by Deliver>Walk, and root>Deliver (priority 10) goes before root>Rest (priority 1)","held":{"group":"Walk","by":"Deliver>Walk"},"notes":["it is held for Deliver, priority 1, that for the program, priority 10"]})json");
}

TEST_CASE("the answer of why is whole, however long a name is") {
  const Shut waiting;
  static const std::string condition(5000, 'x');
  Names names = courier::names::all();
  names.condition = [](const void*, Index) { return condition.c_str(); };
  Index row = 0;
  while (courier::names::group(row) != std::string_view("Open")) ++row;
  std::string out;
  live::append_why(waiting.behaviour.seen().view(), row, names, out);
  CHECK(out.find("until " + condition + ", which no enabled provider promises\"") != std::string::npos);
}

TEST_CASE("the answer of why has the value of the state in a false condition, and the providers that could cause it") {
  const Shut waiting;
  const auto why = [&](std::string_view group) {
    Index row = 0;
    while (courier::names::group(row) != group) ++row;
    return waiting.why(row);
  };
  CHECK(
      why("Open") ==
      R"({"group":"Open","kind":"condition","text":"Open waits (Deliver>Open): until Door == open, which no enabled provider promises","notes":["Door is shut","Open.unlocking could cause it, and is disabled"]})");
  CHECK(
      why("Walk") ==
      R"!({"group":"Walk","kind":"running","text":"Walk runs (Rest>Walk)","notes":["it runs for Rest, priority 0, that for the program, priority 1"]})!");
}
