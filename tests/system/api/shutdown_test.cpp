// SPDX-License-Identifier: MIT
// The end of a program: everything is cancelled together, and comes to rest.
#include "tests/system/api/office.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace director;
using namespace director::tests;
using namespace std::chrono_literals;
using courier::Battery, courier::Bell, courier::Deliver, courier::Rest, courier::Walk;
using Lines = std::vector<std::string>;

/// Deliver walks, and Rest would walk if Deliver did not.
struct Busy : Office {
  Busy() {
    plans.deliver = [](Deliver::Default& run) { return run.carry(Walk{post::Steps{1}}); };
    plans.rest = [](Rest::Default& run) { return run.request(Walk{post::Steps{2}}); };
    skills.on_stop = [this](Walk::Stop& run) { stopped.push_back(run.task().count); };
    behaviour.request(Deliver{{std::make_unique<int>(1)}}, Rest{});
    behaviour.step(0s);
    record.take();
  }
  std::vector<int> stopped;
};

TEST_CASE("all root tasks are cancelled together: what runs stops, and nothing starts in between") {
  Busy busy;
  CHECK(busy.behaviour.cancel_all());
  CHECK(busy.behaviour.step(0s) == StepResult::quiescent);
  CHECK(busy.record.take() == Lines{"stop Walk"});
  CHECK(busy.stopped == std::vector<int>{1});
  CHECK(busy.behaviour.state<Deliver>() == RunState::none);
  CHECK(busy.behaviour.state<Rest>() == RunState::none);
  CHECK(busy.behaviour.cancel_all());
  CHECK(busy.behaviour.step(0s) == StepResult::quiescent);
  CHECK(busy.record.take().empty());
}

TEST_CASE("a full inbox does not refuse to cancel all, and keeps the order of inputs around it") {
  Busy busy;
  while (busy.behaviour.fire<Bell>()) {}
  CHECK(busy.behaviour.set(Battery{1}));
  CHECK(busy.behaviour.request(Deliver{{std::make_unique<int>(2)}})); // is cancelled as well
  CHECK(busy.behaviour.post().cancel_all());
  CHECK(busy.behaviour.request<Rest>()); // is not
  busy.behaviour.step(0s);
  CHECK(busy.behaviour.state<Deliver>() == RunState::none);
  CHECK(busy.behaviour.state<Rest>() == RunState::running);
  CHECK(busy.stopped == std::vector<int>{1});
}

TEST_CASE("from inside a body all can be cancelled by post only") {
  Busy busy;
  busy.plans.rest = [&](Rest::Default& run) {
    CHECK(!busy.behaviour.cancel_all());
    CHECK(busy.behaviour.post().cancel_all());
    return run.keep();
  };
  busy.behaviour.request<Rest>();
  busy.behaviour.step(0s);
  CHECK(busy.behaviour.state<Deliver>() == RunState::running);
  busy.behaviour.step(0s);
  CHECK(busy.behaviour.state<Deliver>() == RunState::none);
}

TEST_CASE("a stop handler that throws at the end keeps no other from its own") {
  Busy busy;
  busy.skills.on_stop = [&](Walk::Stop&) { throw std::runtime_error("the legs do not answer"); };
  busy.behaviour.cancel_all();
  CHECK_THROWS_AS(busy.behaviour.step(0s), std::runtime_error);
  CHECK(busy.behaviour.step(0s) == StepResult::quiescent);
  CHECK(busy.behaviour.state<Rest>() == RunState::none);
}

TEST_CASE("the end of a behaviour that runs calls nothing, as its modules may be gone") {
  std::vector<int> stopped;
  {
    auto busy = std::make_unique<Busy>();
    busy->skills.on_stop = [&](Walk::Stop& run) { stopped.push_back(run.task().count); };
  }
  CHECK(stopped.empty());
}

} // namespace
