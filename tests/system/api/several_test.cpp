// SPDX-License-Identifier: MIT
// Several behaviours in one process, of one and of several specifications: they are independent.
#include "janitor.hpp"
#include "tests/system/api/office.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdint>
#include <memory>
#include <thread>

namespace {

using namespace director;
using namespace director::tests;
using namespace std::chrono_literals;

struct House final : janitor::House {
  Outcome provide(janitor::Rest::Default& run) override { return run.request(janitor::Walk{1}); }
  Outcome provide(janitor::Sweep::Default& run) override { return run.request(janitor::Walk{2}); }
  Outcome provide(janitor::Polish::Default& run) override {
    wax.push_back(run.task().grams);
    aligned = aligned && reinterpret_cast<std::uintptr_t>(&run.task()) % alignof(post::Wax) == 0;
    return run.keep();
  }
  Outcome provide(janitor::Walk::Default& run) override {
    steps.push_back(run.task());
    return run.keep();
  }
  void stop(janitor::Walk::Stop& run) override { steps.push_back(-run.task()); }
  std::vector<int> steps, wax;
  bool aligned = true;
};

struct Home {
  House house;
  janitor::Behaviour behaviour{house};
};

TEST_CASE("behaviours of one specification and of another run side by side") {
  Office office;
  Home one, two;
  office.plans.rest = [&](courier::Rest::Default& run) {
    CHECK(one.behaviour.post().set(janitor::Door::open)); // a body of one may post to another
    return run.request(courier::Walk{post::Steps{3}});
  };
  one.behaviour.request<janitor::Sweep>();
  two.behaviour.request<janitor::Rest>();
  office.behaviour.request<courier::Rest>();
  one.behaviour.step();
  two.behaviour.step();
  CHECK(one.house.steps.empty());
  CHECK(two.house.steps == std::vector<int>{1});
  CHECK(one.behaviour.why<janitor::Sweep>().kind == Because::Kind::condition);
  office.behaviour.step(0s);
  one.behaviour.step();
  CHECK(one.house.steps == std::vector<int>{2});
  CHECK(office.behaviour.state<courier::Rest>() == RunState::running);
  two.behaviour.cancel<janitor::Rest>();
  two.behaviour.step();
  CHECK(two.house.steps == std::vector<int>{1, -1});
  CHECK(one.behaviour.holding<janitor::Walk>().granted);
}

TEST_CASE("data that cannot be copied and need a boundary of their own are moved about and destroyed once") {
  {
    auto home = std::make_unique<Home>();
    home->behaviour.request(janitor::Polish{post::Wax{1}});
    home->behaviour.step();
    home->behaviour.request(janitor::Polish{post::Wax{2}, janitor::Polish::hard});
    home->behaviour.request(janitor::Polish{post::Wax{3}});
    home->behaviour.step();
    home->behaviour.request(janitor::Polish{post::Wax{4}}); // waits when the behaviour ends
    CHECK(home->house.wax == std::vector<int>{1, 3});
    CHECK(home->house.aligned);
    CHECK(post::Wax::alive > 0);
  }
  CHECK(post::Wax::alive == 0);
}

TEST_CASE("the destructor of data is inside of the step that replaces them: only post reaches the behaviour") {
  Home home;
  int ended = 0;
  bool requested = true;
  StepResult step = StepResult::quiescent;
  home.behaviour.request(janitor::Polish{post::Wax{1, [&] {
                                                     ++ended;
                                                     requested = home.behaviour.request<janitor::Sweep>();
                                                     step = home.behaviour.step();
                                                     home.behaviour.post().request<janitor::Rest>();
                                                   }}});
  home.behaviour.step();
  home.behaviour.request(janitor::Polish{post::Wax{2}}, janitor::Sweep{});
  home.behaviour.step();
  CHECK(ended == 1);
  CHECK(!requested);
  CHECK(step == StepResult::refused);
  CHECK(home.behaviour.state<janitor::Rest>() == RunState::none);
  home.behaviour.step();
  CHECK(home.behaviour.state<janitor::Rest>() == RunState::running);
  CHECK(home.house.wax == std::vector<int>{1, 2});
}

TEST_CASE("a behaviour may be stepped inside a body of another") {
  Office office;
  Home home;
  StepResult inner = StepResult::refused;
  office.plans.rest = [&](courier::Rest::Default& run) {
    home.behaviour.request<janitor::Rest>();
    inner = home.behaviour.step();
    return run.keep();
  };
  office.behaviour.request<courier::Rest>();
  office.behaviour.step(0s);
  CHECK(inner == StepResult::quiescent);
  CHECK(home.house.steps == std::vector<int>{1});
}

TEST_CASE("each behaviour may have a thread of its own") {
  Home homes[3];
  std::thread threads[3];
  for (int i = 0; i < 3; ++i) {
    threads[i] = std::thread([&home = homes[i], i] {
      for (int round = 0; round < 200; ++round) {
        home.behaviour.request<janitor::Rest>();
        home.behaviour.step();
      }
      if (i == 2) home.behaviour.cancel<janitor::Rest>();
      home.behaviour.step();
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(homes[0].house.steps == std::vector<int>(200, 1));
  CHECK(homes[1].house.steps == homes[0].house.steps);
  CHECK(homes[2].house.steps.back() == -1);
}

} // namespace
