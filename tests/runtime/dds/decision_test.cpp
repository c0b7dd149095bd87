// SPDX-License-Identifier: MIT
#include "runtime/dds/decision.hpp"
#include "tests/runtime/dds/robot.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>

using namespace director;
using namespace director::tests;

namespace {

/// All decisions of one behaviour, as text.
struct Recorded {
  static void observe(void* self, const Event& event) {
    Recorded& told = *static_cast<Recorded*>(self);
    const dds::Decision d = dds::decision_of(event, *told.plug);
    using enum Event::Kind;
    constexpr std::array no_decisions{set, input, ask, answer, assign, begin, given};
    if (std::find(no_decisions.begin(), no_decisions.end(), event.kind) == no_decisions.end())
      told.decisions.push_back(d.kind + " " + d.group + "." + d.provider + " for " + d.requester + ": " + d.reason);
    if (const auto ended = told.promises->observe(event))
      told.ended.push_back((ended->kept ? "kept " : "broken ") + ended->group + "." + ended->provider + ": " +
                           ended->condition);
  }
  const dds::Plug* plug = nullptr;
  dds::Promises* promises = nullptr;
  std::vector<std::string> decisions, ended;
};

/// A behaviour with an observer of every event.
struct Heard {
  Heard() {
    told.plug = &plugged;
    told.promises = &promises;
  }
  Plans plans;
  Skills skills;
  Recorded told;
  courier::Behaviour behaviour{plans, skills, {&Recorded::observe, &told}};
  const dds::Plug plugged = plug(behaviour);
  dds::Promises promises{plugged};
};

} // namespace

TEST_CASE("a decision is published with names") {
  Heard heard;
  heard.plans.rest = [](courier::Rest::Default& run) { return run.request(courier::Sing{}); };
  heard.behaviour.request<courier::Rest>();
  heard.behaviour.step(0s);
  CHECK(heard.told.decisions ==
        std::vector<std::string>{"grant Rest.default for root: ", "run Rest.default for : new_task",
                                 "grant Sing.default for Rest: ", "run Sing.default for : new_task"});
}

TEST_CASE("a promise is kept by the run of its provider, and broken when its time is over") {
  Heard heard;
  const auto hear = [&](Event event) {
    if (const auto ended = heard.promises.observe(event))
      heard.told.ended.push_back((ended->kept ? "kept " : "broken ") + ended->condition);
  };
  const Tables& t = heard.plugged.tables();
  Index unlocking = 0;
  while (std::string(courier::names::provider(unlocking)) != "unlocking") ++unlocking;
  const Index open = t.providers[unlocking].group, door = state_row("Door");
  observe({.kind = Event::Kind::run, .group = open, .provider = unlocking, .micro_step = 5});
  observe({.kind = Event::Kind::set, .state = door, .value = 0, .micro_step = 5});
  CHECK(heard.told.ended.empty());
  observe({.kind = Event::Kind::set, .state = door, .value = 1, .micro_step = 6}); // by a handler, or a timer
  CHECK(heard.told.ended.empty());
  observe({.kind = Event::Kind::set, .state = door, .value = 1, .micro_step = 5});
  observe({.kind = Event::Kind::broken, .group = open, .provider = unlocking, .micro_step = 9});
  CHECK(heard.told.ended == std::vector<std::string>{"kept Door == open", "broken Door == open"});
}
