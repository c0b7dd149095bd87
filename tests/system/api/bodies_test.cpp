// SPDX-License-Identifier: MIT
#include "tests/system/api/office.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <stdexcept>

namespace {

using namespace director;
using namespace director::tests;
using namespace std::chrono_literals;
using courier::Deliver, courier::Open, courier::Rest, courier::Sing, courier::Walk;
using Lines = std::vector<std::string>;

TEST_CASE("a task's data reach its body, the program's and those of a body") {
  Office office;
  office.plans.deliver = [](Deliver::Default& run) {
    return run.carry(Walk{post::Steps{*run.task().weight * 2}, Walk::fast});
  };
  std::vector<int> steps;
  office.skills.on_start = [&](Walk::Start& run) { steps.push_back(run.task().count); };
  office.skills.walk = [&](Walk::Default& run) {
    steps.push_back(run.task().count);
    return run.keep();
  };
  office.skills.on_stop = [&](Walk::Stop& run) { steps.push_back(-run.task().count); };
  office.behaviour.request(Deliver{parcel(21)});
  CHECK(office.behaviour.step(0s) == StepResult::quiescent);
  CHECK(steps == std::vector<int>{42, 42});
  office.behaviour.cancel<Deliver>();
  office.behaviour.step(0s);
  CHECK(steps == std::vector<int>{42, 42, -42});
}

TEST_CASE("a kept entry leaves the request and its data as they are") {
  Office office;
  int asked = 0;
  office.plans.deliver = [&](Deliver::Default& run) {
    return run.carry(keep(Walk{post::Steps{++asked}}), keep(Sing{}));
  };
  std::vector<int> steps;
  office.skills.walk = [&](Walk::Default& run) {
    steps.push_back(run.task().count);
    return run.keep();
  };
  office.behaviour.request(Deliver{parcel(1)});
  office.behaviour.step(0s);
  office.behaviour.request(Deliver{parcel(1)});
  office.behaviour.step(0s);
  CHECK(asked == 2);
  CHECK(steps == std::vector<int>{1});
}

TEST_CASE("of several requests in one run the last one counts alone") {
  Office office;
  std::vector<int> steps;
  office.plans.rest = [](Rest::Default& run) {
    Outcome answer = run.request(Walk{post::Steps{1}}, Sing{});
    answer = run.request(Sing{});
    return answer;
  };
  office.plans.deliver = [](Deliver::Default& run) {
    Outcome answer = run.enter(Open{}, Walk{post::Steps{2}});
    answer = run.carry(Walk{post::Steps{3}});
    return answer;
  };
  office.skills.walk = [&](Walk::Default& run) {
    steps.push_back(run.task().count);
    return run.keep();
  };
  office.behaviour.request<Rest>();
  office.behaviour.step(0s);
  CHECK(office.record.take() == Lines{"run Rest.default", "run Sing.default"});
  office.behaviour.request(Deliver{parcel(1)});
  office.behaviour.step(0s);
  CHECK(steps == std::vector<int>{3});
  CHECK(office.record.take() == Lines{"run Deliver.default", "start Walk", "run Walk.default"});
}

TEST_CASE("of 257 requests in one run the last one counts alone") {
  Office office;
  int requests = 256;
  office.plans.rest = [&](Rest::Default& run) {
    Outcome answer = run.request(Sing{});
    for (int i = 1; i < requests; ++i) answer = run.request();
    return answer;
  };
  for (; requests <= 257; ++requests) {
    office.behaviour.request<Rest>();
    office.behaviour.step(0s);
    CHECK(office.record.take() == Lines{"run Rest.default"});
  }
}

TEST_CASE("a request that is a fault leaves nothing to the next one of the same run") {
  Office office;
  office.plans.rest = [](Rest::Default& run) {
    Outcome answer = run.request(Sing{}, Walk{post::Steps{}, Walk::fast});
    if (answer.kind() == Outcome::Kind::fault) answer = run.request(Walk{post::Steps{}});
    return answer;
  };
  office.behaviour.request<Rest>();
  CHECK(office.behaviour.step(0s) == StepResult::quiescent);
  CHECK(office.record.take() == Lines{"run Rest.default", "start Walk", "run Walk.default"});
}

TEST_CASE("a level that the requester does not declare is a fault, and nothing is requested") {
  Office office;
  office.plans.rest = [](Rest::Default& run) { return run.request(Walk{post::Steps{}, Walk::fast}, Sing{}); };
  office.behaviour.request<Rest>();
  CHECK(office.behaviour.step(0s) == StepResult::fault);
  CHECK(office.behaviour.step(0s) == StepResult::quiescent);
  CHECK(office.record.take() == Lines{"run Rest.default", "fault Rest"});
}

TEST_CASE("a body sees how what it uses fares, and what it requested") {
  Office office;
  std::vector<RunState> seen;
  bool failed = false;
  office.plans.deliver = [&](Deliver::Default& run) {
    const Used walk = run.uses<Walk>();
    seen.push_back(walk.state());
    failed = walk.failed();
    if (walk.done()) return run.done();
    return run.carry(Walk{post::Steps{}});
  };
  office.skills.walk = [](Walk::Default& run) { return run.fail(); };
  office.behaviour.request(Deliver{parcel(1)});
  office.behaviour.step(0s);
  CHECK(seen == std::vector<RunState>{RunState::none, RunState::running});
  CHECK(failed);
  CHECK(office.behaviour.state<Deliver>() == RunState::none);
}

TEST_CASE("a computed value is set only where it is declared") {
  Office office;
  std::vector<bool> answers;
  office.skills.walk = [&](Walk::Default& run) {
    for (const std::int32_t charge : {49, 50, 200}) answers.push_back(run.try_set(courier::Battery{charge}));
    return run.keep();
  };
  office.plans.rest = [](Rest::Default& run) { return run.request(Walk{post::Steps{}}); };
  office.behaviour.request<Rest>();
  office.behaviour.step(0s);
  CHECK(answers == std::vector<bool>{true, false, false});
  CHECK(office.record.take() == Lines{"run Rest.default", "start Walk", "run Walk.default", "refused Battery 50",
                                      "refused Battery 200", "set Battery 49"});
}

TEST_CASE("a wait and a trigger run a body again, and it can distinguish them") {
  Office office;
  Lines why;
  office.plans.deliver = [&](Deliver::Default& run) {
    if (run.reasons().has(Reason::wait)) why.push_back("wait");
    if (run.triggered<courier::Bell>()) why.push_back("bell");
    if (run.triggered<Broken<Open::Unlocking>>()) why.push_back("broken");
    run.wait(1500us);
    return run.keep();
  };
  office.behaviour.request(Deliver{parcel(1)});
  office.behaviour.step(0s);
  office.behaviour.step(1499us);
  CHECK(why.empty());
  office.behaviour.step(1500us);
  CHECK(office.behaviour.fire<courier::Bell>());
  office.behaviour.step(1600us);
  CHECK(why == Lines{"wait", "bell"});
}

TEST_CASE("what a body throws leaves step after its micro-step, and the behaviour goes on") {
  Office office;
  office.plans.rest = [](Rest::Default& run) { return run.request(Walk{post::Steps{}}, Sing{}); };
  office.skills.on_start = [](Walk::Start&) { throw std::runtime_error("no ground"); };
  office.skills.walk = [](Walk::Default&) -> Outcome { throw std::runtime_error("stumbled"); };
  office.behaviour.request<Rest>();
  CHECK_THROWS_WITH(office.behaviour.step(0s), "no ground");
  CHECK_THROWS_WITH(office.behaviour.step(0s), "stumbled");
  CHECK(office.behaviour.step(0s) == StepResult::quiescent);
  CHECK(office.record.take() ==
        Lines{"run Rest.default", "start Walk", "fault Walk", "run Walk.default", "fault Walk", "run Sing.default"});
}

TEST_CASE("what a handler set before it threw counts") {
  Office office;
  office.plans.deliver = [](Deliver::Default& run) { return run.enter(Open{}, Walk{post::Steps{}}); };
  office.skills.unlocking = [](Open::Unlocking& run) {
    run.set(courier::Door::open);
    return run.keep();
  };
  office.skills.on_stop = [](Walk::Stop& run) {
    run.set(courier::Door::shut);
    throw std::runtime_error("no brake");
  };
  office.behaviour.request(Deliver{parcel(1)});
  office.behaviour.step(0s);
  CHECK(office.behaviour.engine().value(1) == static_cast<std::int32_t>(courier::Door::open));
  office.behaviour.cancel<Deliver>();
  CHECK_THROWS_WITH(office.behaviour.step(0s), "no brake");
  CHECK(office.behaviour.step(0s) == StepResult::quiescent);
  CHECK(office.behaviour.engine().value(1) == static_cast<std::int32_t>(courier::Door::shut));
}

TEST_CASE("a budget of 0 is no limit") {
  Office office;
  office.behaviour.set_budget(1);
  office.behaviour.request<Rest>();
  CHECK(office.behaviour.step(0s) == StepResult::budget_exhausted);
  office.behaviour.set_budget(0);
  CHECK(office.behaviour.step(0s) == StepResult::quiescent);
}

TEST_CASE("from inside a body only post reaches the behaviour") {
  Office office;
  bool direct = true, posted = false;
  StepResult step = StepResult::quiescent;
  office.skills.sing = [&](Sing::Default& run) {
    direct = office.behaviour.set(post::Mood::hurried);
    posted = office.behaviour.post().set(post::Mood::hurried);
    step = office.behaviour.step(0s);
    return run.keep();
  };
  office.plans.rest = [](Rest::Default& run) { return run.request(Sing{}); };
  office.behaviour.request<Rest>();
  office.behaviour.step(0s);
  CHECK(!direct);
  CHECK(posted);
  CHECK(step == StepResult::refused);
}

} // namespace
