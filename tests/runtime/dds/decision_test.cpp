// SPDX-License-Identifier: MIT
#include "runtime/dds/decision.hpp"
#include "tests/runtime/dds/keeper_module.hpp"
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
    Recorded& recorded = *static_cast<Recorded*>(self);
    const dds::Decision d = dds::decision_of(event, *recorded.plug);
    using enum Event::Kind;
    constexpr std::array no_decisions{set, input, ask, answer, assign, begin, given};
    if (std::find(no_decisions.begin(), no_decisions.end(), event.kind) == no_decisions.end())
      recorded.decisions.push_back(d.kind + " " + d.group + "." + d.provider + " for " + d.requester + ": " + d.reason);
    if (const auto ended = recorded.promises->observe(event))
      recorded.ended.push_back((ended->kept ? "kept " : "broken ") + ended->group + "." + ended->provider + ": " +
                               ended->condition);
  }
  const dds::Plug* plug = nullptr;
  dds::Promises* promises = nullptr;
  std::vector<std::string> decisions, ended;
};

/// A behaviour with an observer of every event.
struct Observed {
  Observed() {
    recorded.plug = &plugged;
    recorded.promises = &promises;
  }
  Plans plans;
  Skills skills;
  Recorded recorded;
  courier::Behaviour behaviour{plans, skills, {&Recorded::observe, &recorded}};
  const dds::Plug plugged = plug(behaviour);
  dds::Promises promises{plugged};
};

} // namespace

TEST_CASE("a decision is published with names") {
  Observed observed;
  observed.plans.rest = [](courier::Rest::Default& run) { return run.request(courier::Sing{}); };
  observed.behaviour.request<courier::Rest>();
  observed.behaviour.step(0s);
  CHECK(observed.recorded.decisions ==
        std::vector<std::string>{"grant Rest.default for root: ", "run Rest.default for : new_task",
                                 "grant Sing.default for Rest: ", "run Sing.default for : new_task"});
}

TEST_CASE("a push names the request that waits, and nobody as the requester of what is pushed") {
  KeeperModule module;
  keeper::Behaviour behaviour{module};
  const dds::Plug plugged = plug(behaviour);
  const Tables& t = plugged.tables();
  const dds::Decision push = dds::decision_of(
      {.kind = Event::Kind::push, .group = t.providers[0].group, .provider = 0, .edge = 0, .condition = 0}, plugged);
  CHECK(push.requester.empty());
  CHECK(push.reason == "for " + std::string(keeper::names::edge(0)) + ": " + std::string(keeper::names::condition(0)));
}

TEST_CASE("a promise is kept by the run of its provider, and broken when its time is over") {
  Observed observed;
  const auto observe = [&](Event event) {
    if (const auto ended = observed.promises.observe(event))
      observed.recorded.ended.push_back((ended->kept ? "kept " : "broken ") + ended->condition);
  };
  const Tables& t = observed.plugged.tables();
  Index unlocking = 0;
  while (std::string(courier::names::provider(unlocking)) != "unlocking") ++unlocking;
  const Index open = t.providers[unlocking].group, door = state_row("Door");
  observe({.kind = Event::Kind::run, .group = open, .provider = unlocking, .micro_step = 5});
  observe({.kind = Event::Kind::set, .state = door, .value = 0, .micro_step = 5});
  CHECK(observed.recorded.ended.empty());
  observe({.kind = Event::Kind::set, .state = door, .value = 1, .micro_step = 6}); // by a handler, or a timer
  CHECK(observed.recorded.ended.empty());
  observe({.kind = Event::Kind::set, .state = door, .value = 1, .micro_step = 5});
  observe({.kind = Event::Kind::broken, .group = open, .provider = unlocking, .micro_step = 9});
  CHECK(observed.recorded.ended == std::vector<std::string>{"kept Door == open", "broken Door == open"});
}

TEST_CASE("a promise is not kept by a value that only others wait for") {
  KeeperModule module;
  keeper::Behaviour behaviour{module};
  const dds::Plug plugged = plug(behaviour);
  dds::Promises promises{plugged};
  const auto kept = [&](std::string_view provider, std::int32_t value, Index state = 0) {
    Index row = 0;
    while (keeper::names::provider(row) != provider) ++row;
    promises.observe({.kind = Event::Kind::run, .provider = row, .micro_step = 5});
    const auto ended = promises.observe({.kind = Event::Kind::set, .state = state, .value = value, .micro_step = 5});
    return ended ? ended->condition : std::string("not kept");
  };
  constexpr std::int32_t close = 2, near = 3;
  CHECK(kept("approaching", close) == "not kept");
  CHECK(kept("approaching", near) == "Ball == near");
  CHECK(kept("walking", close) == "not kept"); // which has no time
  CHECK(kept("walking", near) != "not kept");
  CHECK(kept("looking", near) == "not kept"); // which promises nothing
  // Two promises of one state: one of them is kept.
  constexpr Index gate = 2;
  constexpr std::int32_t stuck = 0, open = 1, shut = 2;
  CHECK(kept("default", open, gate) == "not kept"); // the first group's, which promises nothing
  CHECK(kept("swinging", open, gate) == "Gate == open");
  CHECK(kept("swinging", shut, gate) == "Gate == shut");
  CHECK(kept("swinging", stuck, gate) == "not kept");
}
