// SPDX-License-Identifier: MIT
#include "tests/system/api/office.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace {

using namespace director;
using namespace director::tests;
using namespace std::chrono_literals;
using courier::Battery, courier::Deliver, courier::Rest, courier::Walk;
using Lines = std::vector<std::string>;

TEST_CASE("several states are set at once, or none of them where a value is outside") {
  Office office;
  const auto value = [&](Index state) { return office.behaviour.engine().value(state); };
  CHECK(office.behaviour.set(post::Mood::hurried, Battery{100}));
  office.behaviour.step(0s);
  CHECK(value(0) == 1);
  CHECK(value(2) == 100);
  CHECK(!office.behaviour.set(post::Mood::calm, Battery{101}));
  CHECK(!office.behaviour.set(Battery{-11}));
  CHECK(!office.behaviour.set(static_cast<post::Mood>(99), Battery{1}));
  office.behaviour.step(0s);
  CHECK(value(0) == 1);
  CHECK(value(2) == 100);
}

TEST_CASE("root tasks come together, at the level that is named") {
  Office office;
  CHECK(office.behaviour.request(Deliver{{std::make_unique<int>(1)}, Deliver::urgent}, Rest{}));
  CHECK(office.behaviour.state<Deliver>() == RunState::none);
  office.behaviour.step(0s);
  CHECK(office.behaviour.state<Deliver>() == RunState::running);
  CHECK(office.behaviour.state<Rest>() == RunState::running);
  CHECK(office.record.take() == Lines{"run Deliver.default", "run Rest.default"});
}

TEST_CASE("a provider that is not enabled does not run") {
  Office office;
  CHECK(office.behaviour.enable<Rest::Default>(false));
  office.behaviour.request<Rest>();
  office.behaviour.step(0s);
  CHECK(office.behaviour.state<Rest>() == RunState::queued);
  CHECK(office.behaviour.enable<Rest::Default>(true));
  office.behaviour.step(0s);
  CHECK(office.behaviour.state<Rest>() == RunState::running);
}

TEST_CASE("of more requests with data than there are places for, the last one counts") {
  Office office;
  std::vector<int> weights;
  office.plans.deliver = [&](Deliver::Default& run) {
    weights.push_back(*run.task().weight);
    return run.keep();
  };
  for (int i = 1; i <= 9; ++i) CHECK(office.behaviour.request(Deliver{{std::make_unique<int>(i)}}, Rest{}));
  office.behaviour.step(0s);
  CHECK(weights == std::vector<int>{9});
  CHECK(office.behaviour.request(Deliver{{std::make_unique<int>(10)}}));
  office.behaviour.step(0s);
  CHECK(weights == std::vector<int>{9, 10});
}

TEST_CASE("a full inbox refuses everything but single states, and requests and cancels of root tasks") {
  Office office;
  int weight = 0;
  office.plans.deliver = [&](Deliver::Default& run) {
    weight = *run.task().weight;
    return run.keep();
  };
  office.behaviour.request<Rest>();
  office.behaviour.step(0s);
  while (office.behaviour.fire<courier::Bell>()) {}
  CHECK(!office.behaviour.set(Battery{1}, post::Mood::calm));
  CHECK(!office.behaviour.enable<Rest::Default>(false));
  for (int i = 1; i <= 9; ++i) CHECK(office.behaviour.request(Deliver{{std::make_unique<int>(i)}}));
  CHECK(office.behaviour.cancel<Rest>());
  office.behaviour.step(0s);
  CHECK(weight == 9);
  CHECK(office.behaviour.state<Deliver>() == RunState::running);
  CHECK(office.behaviour.state<Rest>() == RunState::none);
}

TEST_CASE("a level that the program does not declare is refused, also by a full inbox") {
  Office office;
  while (office.behaviour.fire<courier::Bell>()) {}
  CHECK(!office.behaviour.request(Deliver{{std::make_unique<int>(1)}, LevelOf<Deliver>{7}}));
  CHECK(office.behaviour.request(Deliver{{std::make_unique<int>(1)}, Deliver::urgent}));
}

TEST_CASE("other threads post: nothing that was accepted is lost, and of requests the last one counts") {
  Office office;
  const auto post = office.behaviour.post();
  constexpr int times = 20'000;
  int accepted[2] = {0, 0};
  const auto work = [&](int& count, int sign) {
    for (int i = 1; i <= times; ++i) {
      count += post.fire<courier::Bell>() ? 1 : 0;
      post.request(Deliver{{std::make_unique<int>(sign * i)}});
    }
  };
  int weight = 0;
  office.plans.deliver = [&](Deliver::Default& context) {
    weight = *context.task().weight;
    return context.keep();
  };
  std::thread first(work, std::ref(accepted[0]), 1), second(work, std::ref(accepted[1]), -1);
  for (int i = 0; i < 2'000; ++i) office.behaviour.step(0s);
  first.join();
  second.join();
  office.behaviour.step(0s);
  office.behaviour.step(0s);
  CHECK(std::abs(weight) == times);
  CHECK(office.behaviour.engine().memory().counters->micro_step >=
        static_cast<std::uint64_t>(accepted[0] + accepted[1]));
}

TEST_CASE("two behaviours of one kind know nothing of each other") {
  Office one, two;
  one.behaviour.request<Rest>();
  one.behaviour.step(0s);
  two.behaviour.step(0s);
  CHECK(one.record.take() == Lines{"run Rest.default"});
  CHECK(two.record.take().empty());
}

TEST_CASE("a program may query the holder of a task, and why one does not run, also as text") {
  Office office;
  office.plans.deliver = [](Deliver::Default& run) { return run.carry(Walk{post::Steps{}}); };
  office.plans.rest = [](Rest::Default& run) { return run.request(Walk{post::Steps{}}); };
  office.behaviour.request<Rest>();
  CHECK(office.behaviour.why<Walk>().kind == Because::Kind::not_requested);
  office.behaviour.step(0s);
  office.behaviour.request(Deliver{{std::make_unique<int>(1)}});
  office.behaviour.step(0s);
  const Holding holding = office.behaviour.holding<Walk>();
  CHECK(holding.by == Holding::By::group);
  CHECK(std::string(courier::names::group(holding.group)) == "Deliver");
  CHECK(office.behaviour.holding<courier::Open>().by == Holding::By::nobody);
  char buffer[200];
  CHECK(std::string(courier::names::why(office.behaviour.why<Deliver>(), buffer)) == "Deliver runs (root>Deliver)");
  CHECK(office.behaviour.enable<Deliver::Default>(false));
  office.behaviour.step(0s);
  CHECK(std::string(courier::names::why(office.behaviour.why<Deliver>(), buffer)) ==
        "Deliver waits (root>Deliver): no provider of Deliver is enabled");
  CHECK(std::string(courier::names::why(office.behaviour.why<Deliver>(), std::span(buffer, 8))) == "Deliver");
  CHECK(std::string(courier::names::why(office.behaviour.why<Deliver>(), {})).empty());
}

TEST_CASE("another thread sees what was shown last, whatever has happened since") {
  Office office;
  courier::Behaviour::Snapshot snapshot;
  CHECK(!snapshot.look());
  office.behaviour.request<Rest>();
  office.behaviour.step(0s);
  CHECK(office.behaviour.show(snapshot));
  office.behaviour.cancel<Rest>();
  office.behaviour.step(0s);
  std::thread([&] {
    const auto look = snapshot.look();
    if (!look) return;
    CHECK((*look).state<Rest>() == RunState::running);
    CHECK((*look).holding<Rest>().by == Holding::By::program);
    CHECK((*look).why<Rest>().kind == Because::Kind::running);
  }).join();
  CHECK(office.behaviour.state<Rest>() == RunState::none);
  CHECK(office.behaviour.show(snapshot));
  CHECK((*snapshot.look()).state<Rest>() == RunState::none);
}

TEST_CASE("rows have names, and what is no row has an empty one") {
  namespace names = courier::names;
  CHECK(std::string(names::edge(0)) == "root>Deliver");
  CHECK(std::string(names::condition(0)) == "Door == open");
  CHECK(std::string(names::trigger(1)) == "Open.unlocking.broken");
  CHECK(std::string(names::value(0, 1)) == "hurried");
  CHECK(std::string(names::value(2, unset)) == "unset");
  CHECK(std::string(names::value(2, 50)).empty());
  CHECK(std::string(names::group(director::nil)).empty());
}

TEST_CASE("a program that gets names only at run time posts by number, and not beyond the type") {
  Office office;
  const auto post = office.behaviour.post();
  const auto edge = [](const char* name) {
    Index row = 0;
    while (std::string(courier::names::edge(row)) != name) ++row;
    return row;
  };
  const auto state = [](const char* name) {
    Index row = 0;
    while (std::string(courier::names::state(row)) != name) ++row;
    return row;
  };
  const Index level = office.behaviour.engine().tables().edges[edge("root>Rest")].levels.begin;
  CHECK(post.request_row(edge("root>Rest"), level));
  CHECK(post.set_row(state("Battery"), 40));
  office.behaviour.step(0s);
  CHECK(office.behaviour.state<Rest>() == RunState::running);
  CHECK(office.behaviour.engine().value(state("Battery")) == 40);
  CHECK(post.cancel_row(edge("root>Rest")));
  office.behaviour.step(0s);
  CHECK(office.behaviour.state<Rest>() == RunState::none);

  CHECK_FALSE(post.request_row(edge("root>Rest"), level + 100));
  CHECK_FALSE(post.request_row(edge("root>Deliver"), 0)); // it carries data
  CHECK_FALSE(post.request_row(edge("Rest>Walk"), level));
  CHECK_FALSE(post.cancel_row(edge("Rest>Walk")));
  CHECK_FALSE(post.set_row(state("Battery"), 101));
  CHECK_FALSE(post.set_row(state("Door"), 1)); // not external
  CHECK_FALSE(post.set_row(99, 1));
}

} // namespace
