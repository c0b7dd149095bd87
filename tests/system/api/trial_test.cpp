// SPDX-License-Identifier: MIT
// Modules tested alone, with runtime/hosted/trial.hpp.
#include "lifter.hpp"
#include "runtime/hosted/trial.hpp"
#include "tests/system/api/office.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace {

using namespace director;
using namespace director::tests;
using namespace std::chrono_literals;
using courier::Deliver, courier::Open, courier::Rest, courier::Sing, courier::Walk;
using director::testing::Fares;
using director::testing::Trial;
using Kind = Outcome::Kind;

TEST_CASE("a body alone: its task, and what it requests, with data and levels") {
  Plans plans;
  plans.deliver = [](Deliver::Default& run) {
    return run.carry(Walk{post::Steps{*run.task().weight * 2}, Walk::fast});
  };
  Trial<Deliver::Default> deliver{parcel(21)};
  const auto answer = deliver.run(plans);
  CHECK(answer.outcome() == Kind::pack);
  CHECK(answer.pack() == "carry");
  CHECK(answer.count() == 1);
  CHECK(answer.requests<Walk>());
  CHECK(answer.requests(Walk::fast));
  CHECK(!answer.requests(Walk::slow));
  CHECK(!answer.requests<Sing>());
  CHECK(!answer.keeps<Walk>());
  CHECK(answer.data<Walk>().count == 42);
  CHECK(!answer.wait());
  CHECK(deliver.task(parcel(1)).run(plans).data<Walk>().count == 2);
}

TEST_CASE("a body alone: a group that is only needed is never granted, done or queued") {
  Trial<lifter::Lift::Default> lift;
  for (const Fares fares : {Fares::queued, Fares::running, Fares::done, Fares::failed})
    CHECK_THROWS_WITH(lift.uses<lifter::Crane>(fares), "nothing of this group requests it: it is always none");
  lift.uses<lifter::Crane>(Fares::none);
}

TEST_CASE("a body alone: of several requests in one run the last one counts alone") {
  Plans plans;
  plans.deliver = [](Deliver::Default& run) {
    Outcome answer = run.enter(Open{}, Walk{post::Steps{1}});
    answer = run.carry(Walk{post::Steps{2}});
    return answer;
  };
  Trial<Deliver::Default> deliver{parcel(21)};
  const auto answer = deliver.run(plans);
  CHECK(answer.pack() == "carry");
  CHECK(answer.count() == 1);
  CHECK(answer.data<Walk>().count == 2);
  CHECK(!answer.requests<Open>());

  plans.rest = [](Rest::Default& run) {
    Outcome last = run.request(Sing{});
    for (int i = 1; i < 257; ++i) last = run.request();
    return last;
  };
  CHECK(Trial<Rest::Default>().run(plans).count() == 0);
}

TEST_CASE("a body alone: the reasons for its run, only that time") {
  Plans plans;
  std::vector<Reasons> seen;
  std::vector<bool> rung;
  plans.deliver = [&](Deliver::Default& run) {
    seen.push_back(run.reasons());
    rung.push_back(run.triggered<courier::Bell>());
    run.wait(1500us);
    return run.keep();
  };
  Trial<Deliver::Default> deliver{parcel(1)};
  deliver.run(plans);
  const auto answer = deliver.reasons(Reason::subtask_done, Reason::wait).triggered<courier::Bell>().run(plans);
  deliver.run(plans);
  CHECK(seen == std::vector<Reasons>{Reasons{1}, Reasons{4 + 8 + 16}, Reasons{1}});
  CHECK(rung == std::vector<bool>{false, true, false});
  CHECK(answer.outcome() == Kind::keep);
  CHECK(answer.pack().empty());
  CHECK(answer.wait() == 1500us);
}

TEST_CASE("a body alone: how what it uses fares") {
  Plans plans;
  plans.deliver = [](Deliver::Default& run) {
    const Used walk = run.uses<Walk>();
    if (walk.failed()) return run.fail();
    if (walk.done()) return run.done();
    if (walk.state() == RunState::running) return run.keep();
    return walk.state() == RunState::queued ? run.nothing() : run.enter(Open{}, Walk{post::Steps{}});
  };
  Trial<Deliver::Default> deliver{parcel(1)};
  CHECK(deliver.run(plans).pack() == "enter");
  CHECK(deliver.uses<Walk>(Fares::running).run(plans).outcome() == Kind::keep);
  CHECK(deliver.uses<Walk>(Fares::done).run(plans).outcome() == Kind::done);
  CHECK(deliver.uses<Walk>(Fares::failed).run(plans).outcome() == Kind::failed);
  CHECK(deliver.uses<Walk>(Fares::queued).run(plans).pack() == "nothing");
  CHECK(deliver.uses<Walk>(Fares::none).run(plans).count() == 2);
}

TEST_CASE("a body alone: what it keeps is what it requested before, at that level") {
  Plans plans;
  plans.deliver = [](Deliver::Default& run) { return run.carry(keep(Walk{post::Steps{3}, Walk::slow})); };
  Trial<Deliver::Default> deliver{parcel(1)};
  CHECK(!deliver.run(plans).keeps<Walk>());
  const auto again = deliver.run(plans);
  CHECK(again.keeps<Walk>());
  CHECK_THROWS_WITH(again.data<Walk>(), "this task was kept, with the data that it had");
  CHECK_THROWS_WITH(again.data<Walk>(), "this task was kept, with the data that it had");
  CHECK(!deliver.requested(Walk::fast).run(plans).keeps<Walk>());
  Trial<Deliver::Default> other{parcel(1)};
  CHECK(other.requested(Walk::slow).run(plans).keeps<Walk>());
}

TEST_CASE("a body alone: states that it sets, and values that are refused") {
  Skills skills;
  skills.walk = [](Walk::Default& run) {
    for (const std::int32_t charge : {49, 50}) run.try_set(courier::Battery{charge});
    return run.keep();
  };
  Trial<Walk::Default> walk{post::Steps{1}};
  const auto answer = walk.run(skills);
  CHECK(answer.sets(courier::Battery{49}));
  CHECK(!answer.sets(courier::Battery{48}));
  CHECK(answer.refuses(courier::Battery{50}));
  CHECK(!answer.refuses(courier::Battery{49}));
  skills.walk = [](Walk::Default& run) { return run.keep(); };
  CHECK(!walk.run(skills).sets<courier::Battery>());
  CHECK(!walk.run(skills).sets(courier::Battery{std::numeric_limits<std::int32_t>::min()})); // it cannot be set to that
  static_assert(!std::is_copy_constructible_v<decltype(walk)>);
}

TEST_CASE("a handler alone") {
  Skills skills;
  int steps = 0;
  Reasons why;
  skills.on_stop = [&](Walk::Stop& run) {
    steps = run.task().count;
    why = run.reasons();
    run.set(courier::Door::shut);
  };
  Trial<Walk::Stop> stop{post::Steps{7}};
  CHECK(stop.run(skills).sets(courier::Door::shut));
  CHECK(steps == 7);
  CHECK(why.has(Reason::stopped));
  CHECK(!Trial<Walk::Start>{post::Steps{7}}.run(skills).sets<courier::Door>());
}

TEST_CASE("a body alone that throws: the next run does not hear the trigger again") {
  Plans plans;
  std::vector<bool> rung;
  plans.deliver = [&](Deliver::Default& run) -> Outcome {
    rung.push_back(run.triggered<courier::Bell>());
    if (rung.size() == 1) throw std::runtime_error("too loud");
    return run.keep();
  };
  Trial<Deliver::Default> deliver{parcel(1)};
  CHECK_THROWS_WITH(deliver.triggered<courier::Bell>().run(plans), "too loud");
  deliver.run(plans);
  CHECK(rung == std::vector<bool>{true, false});
}

TEST_CASE("what a body throws passes through a trial, and a level that is not declared is a fault") {
  Plans plans;
  Trial<Rest::Default> rest;
  plans.rest = [](Rest::Default&) -> Outcome { throw std::runtime_error("no chair"); };
  CHECK_THROWS_WITH(rest.run(plans), "no chair");
  plans.rest = [](Rest::Default& run) { return run.request(Walk{post::Steps{}, Walk::fast}, Sing{}); };
  const auto answer = rest.run(plans);
  CHECK(answer.outcome() == Kind::fault);
  CHECK(answer.count() == 0);
  CHECK_THROWS_WITH(answer.data<Walk>(), "this task was not requested");
}

} // namespace
