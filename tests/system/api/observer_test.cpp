// SPDX-License-Identifier: MIT
// Observers that throw, and that call forbidden functions.
#include "tests/system/api/office.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>

namespace {

using namespace director;
using namespace director::tests;
using namespace std::chrono_literals;
using courier::Deliver, courier::Rest, courier::Sing, courier::Walk;
using Kind = Event::Kind;

/// Throws at an event, so many times.
struct Thrower {
  static void tell(void* self, const Event& event) {
    auto& thrower = *static_cast<Thrower*>(self);
    thrower.events += 1;
    if (event.kind != thrower.at || thrower.times == 0) return;
    thrower.times -= 1;
    throw std::runtime_error("told of enough");
  }
  Kind at = Kind::run;
  int times = 1, events = 0;
};

struct Watched {
  Thrower thrower;
  Plans plans;
  Skills skills;
  courier::Behaviour behaviour{plans, skills, {&Thrower::tell, &thrower}};

  /// How often it threw until it was at rest.
  int settle(std::chrono::milliseconds now = 0ms) {
    int thrown = 0;
    for (;;) {
      try {
        if (behaviour.step(now) == StepResult::quiescent) return thrown;
      } catch (const std::runtime_error&) { thrown += 1; }
    }
  }
};

Deliver delivery(int weight) { return Deliver{{std::make_unique<int>(weight)}}; }

TEST_CASE("what an observer throws leaves the step after its micro-step, and everything was done in between") {
  for (const Kind kind : {Kind::input, Kind::grant, Kind::run, Kind::ask, Kind::start, Kind::set, Kind::done,
                          Kind::lose, Kind::stop, Kind::wait, Kind::queue}) {
    CAPTURE(static_cast<int>(kind));
    Watched watched;
    watched.thrower.at = kind;
    std::vector<std::string> calls;
    watched.plans.deliver = [&](Deliver::Default& run) {
      calls.push_back("deliver " + std::to_string(*run.task().weight));
      if (run.reasons().has(Reason::new_task)) run.wait(1s);
      return run.carry(Walk{post::Steps{*run.task().weight}});
    };
    watched.plans.rest = [&](Rest::Default& run) {
      return run.reasons().has(Reason::new_task) ? run.request(Walk{post::Steps{0}}, Sing{}) : run.keep();
    };
    watched.skills.on_start = [&](Walk::Start& run) {
      calls.push_back("start");
      run.set(courier::Door::shut);
    };
    watched.skills.walk = [&](Walk::Default& run) {
      calls.push_back("walk " + std::to_string(run.task().count));
      static_cast<void>(run.try_set(courier::Battery{run.task().count}));
      return run.keep();
    };
    watched.skills.sing = [&](Sing::Default& run) { return run.done(); };
    watched.skills.on_stop = [&](Walk::Stop& run) { calls.push_back("stop " + std::to_string(run.task().count)); };
    watched.behaviour.request(delivery(3));
    watched.behaviour.request<Rest>();
    int thrown = watched.settle();
    watched.behaviour.request(delivery(4));
    thrown += watched.settle();
    watched.behaviour.cancel<Deliver>();
    thrown += watched.settle();
    watched.behaviour.cancel<Rest>();
    thrown += watched.settle();
    CHECK(thrown == 1);
    CHECK(calls == std::vector<std::string>{"deliver 3", "start", "walk 3", "deliver 4", "walk 4", "walk 0", "stop 0"});
  }
}

TEST_CASE("an observer that throws at the end of the budget is heard as well") {
  Watched watched;
  watched.thrower.at = Kind::exhausted;
  watched.behaviour.set_budget(1);
  watched.behaviour.request<Rest>();
  CHECK_THROWS_AS(watched.behaviour.step(0s), std::runtime_error);
  CHECK(watched.settle() == 0);
  CHECK(watched.behaviour.state<Rest>() == RunState::running);
}

TEST_CASE("an observer that throws at an event of lost inputs keeps none of the others") {
  Watched watched;
  watched.thrower.at = Kind::lost;
  while (watched.behaviour.fire<courier::Bell>()) {}
  watched.behaviour.request<Rest>();
  CHECK_THROWS_AS(watched.behaviour.step(0s), std::runtime_error);
  CHECK(watched.behaviour.state<Rest>() == RunState::none);
  CHECK(watched.settle() == 0);
  CHECK(watched.behaviour.state<Rest>() == RunState::running);
}

TEST_CASE("of what a body and an observer throw in one micro-step the first is thrown on") {
  Watched watched;
  watched.plans.rest = [](Rest::Default&) -> Outcome { throw std::logic_error("cannot rest"); };
  watched.behaviour.request<Rest>();
  CHECK_THROWS_AS(watched.behaviour.step(0s), std::runtime_error); // the event of the run, before it
  CHECK(watched.behaviour.step(0s) == StepResult::quiescent);
}

TEST_CASE("an observer may not call the behaviour, but post to it") {
  struct Caller {
    static void tell(void* self, const Event& event) {
      auto& caller = *static_cast<Caller*>(self);
      if (event.kind != Kind::run || caller.behaviour == nullptr) return;
      courier::Behaviour& behaviour = *std::exchange(caller.behaviour, nullptr);
      caller.refused = behaviour.step(1s) == StepResult::refused && !behaviour.request<Rest>() &&
                       !behaviour.set(courier::Battery{1}) && !behaviour.fire<courier::Bell>() &&
                       !behaviour.cancel<Rest>() && !behaviour.enable<Rest::Default>(false);
      caller.posted = behaviour.post().set(courier::Battery{7});
    }
    courier::Behaviour* behaviour = nullptr;
    bool refused = false, posted = false;
  } caller;
  Plans plans;
  Skills skills;
  courier::Behaviour behaviour{plans, skills, {&Caller::tell, &caller}};
  behaviour.request<Rest>();
  caller.behaviour = &behaviour;
  CHECK(behaviour.step(0s) == StepResult::quiescent);
  CHECK(caller.refused);
  CHECK(caller.posted);
  CHECK(behaviour.engine().now() == 0);
  behaviour.step(0s);
  CHECK(behaviour.engine().value(2) == 7);
}

TEST_CASE("without an observer no event is reported") {
  Plans plans;
  Skills skills;
  courier::Behaviour behaviour{plans, skills, Observer{}};
  behaviour.request<Rest>();
  CHECK(behaviour.step(0s) == StepResult::quiescent);
}

} // namespace
