// SPDX-License-Identifier: MIT
// How a full inbox handles inputs: what it refuses, what waits outside of it, and how lost inputs are reported.
#include "tests/system/api/office.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdint>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

namespace {

using namespace director;
using namespace director::tests;
using namespace std::chrono_literals;
using courier::Battery, courier::Bell, courier::Deliver, courier::Rest;
using Lines = std::vector<std::string>;

/// Inputs as they are taken, and what is lost: `Battery 5`, `Bell`, `root>Rest`, `no root>Rest`, `lost 3`.
struct Inputs {
  static void tell(void* self, const Event& event) {
    namespace names = courier::names;
    Lines& lines = static_cast<Inputs*>(self)->lines;
    if (event.kind == Event::Kind::lost) lines.push_back("lost " + std::to_string(event.count));
    if (event.kind != Event::Kind::input) return;
    const std::string value = names::value(event.state, event.value);
    switch (event.input) {
    case Event::Input::set:
      return lines.push_back(std::string(names::state(event.state)) + " " +
                             (value.empty() ? std::to_string(event.value) : value));
    case Event::Input::fire: return lines.push_back(names::trigger(event.trigger));
    case Event::Input::request: return lines.push_back(names::edge(event.edge));
    case Event::Input::cancel: return lines.push_back(std::string("no ") + names::edge(event.edge));
    default: return lines.push_back("else");
    }
  }
  Lines take() { return std::exchange(lines, {}); }
  Lines lines;
};

struct Flooded {
  Flooded() { flood(); }
  void flood() {
    while (behaviour.post().fire<Bell>()) room += 1;
  }
  /// What the next step takes behind the triggers.
  Lines after_the_flood() {
    behaviour.step(0s);
    Lines all = inputs.take();
    std::erase(all, "Bell");
    return all;
  }
  Inputs inputs;
  Plans plans;
  Skills skills;
  courier::Behaviour behaviour{plans, skills, {&Inputs::tell, &inputs}};
  int room = 0;
};

TEST_CASE("a flood of one sensor does not refuse the value of another, which comes behind what was posted before it") {
  Flooded flooded;
  CHECK(flooded.room == 64);
  CHECK(flooded.behaviour.set(Battery{5}));
  CHECK(flooded.behaviour.set(post::Mood::hurried));
  flooded.behaviour.request<Rest>();
  CHECK(flooded.behaviour.post().set(Battery{6}));
  flooded.behaviour.step(0s);
  Lines expected{"lost 2"}; // a Bell, and Battery 5
  expected.insert(expected.end(), 64, "Bell");
  for (const char* line : {"Mood hurried", "root>Rest", "Battery 6"}) expected.emplace_back(line);
  CHECK(flooded.inputs.take() == expected);
  CHECK(flooded.behaviour.engine().value(2) == 6);
  CHECK(flooded.behaviour.lost() == 2);
}

TEST_CASE("a value by number has the same slot as one by type") {
  Flooded flooded;
  CHECK(flooded.behaviour.post().set_row(2, 5));
  CHECK(flooded.behaviour.set(Battery{7}));
  CHECK(flooded.behaviour.post().set_row(0, 1));
  CHECK(flooded.after_the_flood() == Lines{"lost 2", "Battery 7", "Mood hurried"});
}

TEST_CASE("several states are never split: if not all have space, none is set") {
  Flooded flooded;
  CHECK(!flooded.behaviour.set(Battery{5}, post::Mood::hurried));
  CHECK(flooded.behaviour.set(Battery{6}));
  CHECK(!flooded.behaviour.set(post::Mood::hurried, Battery{7}));
  CHECK(flooded.after_the_flood() == Lines{"lost 3", "Battery 6"});
  CHECK(flooded.behaviour.engine().value(0) == 0);
  CHECK(flooded.behaviour.set(post::Mood::hurried, Battery{8}));
  CHECK(flooded.after_the_flood() == Lines{"Mood hurried", "Battery 8"});
}

TEST_CASE("what is set later comes later, through the inbox or outside of it") {
  Flooded flooded;
  std::vector<int> seen;
  CHECK(flooded.behaviour.set(Battery{1}));
  flooded.plans.rest = [&](Rest::Default& run) { // in the middle of a step there is space again
    CHECK(flooded.behaviour.post().set(Battery{2}));
    CHECK(flooded.behaviour.post().set(Battery{3}, post::Mood::hurried));
    CHECK(flooded.behaviour.post().set(Battery{4}));
    return run.keep();
  };
  flooded.behaviour.request<Rest>();
  CHECK(flooded.after_the_flood() == Lines{"lost 1", "Battery 1", "root>Rest"});
  CHECK(flooded.after_the_flood() == Lines{"Battery 2", "Battery 3", "Mood hurried", "Battery 4"});
  CHECK(flooded.behaviour.lost() == 1);
}

TEST_CASE("what waits outside of the inbox is not overtaken where a budget ends before it is taken") {
  Flooded flooded;
  flooded.behaviour.request<Rest>();
  CHECK(flooded.behaviour.set(Battery{1}));
  flooded.behaviour.set_budget(64);
  CHECK(flooded.behaviour.step(0s) == StepResult::budget_exhausted); // behind the triggers, and before the request
  flooded.behaviour.cancel<Rest>();
  CHECK(flooded.behaviour.set(Battery{2}));
  flooded.behaviour.set_budget(Engine::default_budget);
  CHECK(flooded.after_the_flood() == Lines{"lost 1", "root>Rest", "Battery 1", "no root>Rest", "Battery 2"});
  CHECK(flooded.behaviour.state<Rest>() == RunState::none);
  CHECK(flooded.behaviour.engine().value(2) == 2);
}

TEST_CASE("a value that is outside of its state's domain is refused, and nothing is lost") {
  Flooded flooded;
  const std::uint32_t before = flooded.behaviour.lost();
  CHECK(!flooded.behaviour.set(Battery{101}));
  CHECK(!flooded.behaviour.post().set_row(2, -11));
  CHECK(!flooded.behaviour.request(Deliver{{nullptr}, LevelOf<Deliver>{7}}));
  CHECK(flooded.behaviour.lost() == before);
}

TEST_CASE("requests and cancels that take one another's slot are counted as well") {
  Flooded flooded;
  flooded.behaviour.request<Rest>();
  flooded.behaviour.cancel<Rest>();
  flooded.behaviour.request<Rest>();
  CHECK(flooded.after_the_flood() == Lines{"lost 3", "root>Rest"}); // a Bell too
}

TEST_CASE("a call of several tasks whose records are replaced is one lost input, whether by one call or by several") {
  Flooded flooded;
  const std::uint32_t before = flooded.behaviour.lost();
  flooded.behaviour.request(Deliver{parcel(1)}, Rest{});
  CHECK(flooded.behaviour.lost() == before);
  flooded.behaviour.request(Deliver{parcel(2)}, Rest{});
  CHECK(flooded.behaviour.lost() == before + 1);
  flooded.behaviour.cancel<Deliver>();
  CHECK(flooded.behaviour.lost() == before + 2);
  flooded.behaviour.cancel<Rest>();
  CHECK(flooded.behaviour.lost() == before + 2);
  flooded.behaviour.request(Rest{}, Deliver{parcel(3)});
  CHECK(flooded.behaviour.lost() == before + 4); // two cancels
  CHECK(flooded.after_the_flood() == Lines{"lost 5", "root>Deliver", "root>Rest"});
}

TEST_CASE("what was lost is seen from other threads, and reported once") {
  Flooded flooded;
  courier::Behaviour::Snapshot snapshot;
  CHECK(flooded.behaviour.show(snapshot));
  std::uint32_t lost = 0;
  std::thread([&] { lost = (*snapshot.look()).lost(); }).join();
  CHECK(lost == 1);
  CHECK(flooded.behaviour.seen().lost() == 1);
  CHECK(flooded.after_the_flood() == Lines{"lost 1"});
  CHECK(flooded.behaviour.fire<Bell>());
  CHECK(flooded.after_the_flood().empty());
}

TEST_CASE("what is lost while nothing else is posted is reported at the next step, though that has nothing to take") {
  Flooded flooded;
  flooded.behaviour.step(0s);
  flooded.inputs.take();
  flooded.plans.rest = [&](Rest::Default& run) {
    flooded.flood();
    return run.keep();
  };
  flooded.behaviour.request<Rest>();
  flooded.behaviour.step(0s);
  CHECK(flooded.inputs.take() == Lines{"root>Rest"});
  CHECK(flooded.after_the_flood() == Lines{"lost 1"});
}

TEST_CASE("threads that set one state in a flood: the last value of one of them counts, and none is counted twice") {
  Flooded flooded;
  constexpr int writers = 4, rounds = 500;
  std::vector<std::thread> threads;
  for (int writer = 0; writer < writers; ++writer) {
    threads.emplace_back([post = flooded.behaviour.post()] {
      for (int i = 1; i <= rounds; ++i) {
        while (!post.set(Battery{i % 100})) {}
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  const std::uint32_t lost = flooded.behaviour.lost();
  CHECK(lost == 1 + writers * rounds - 1); // the Bell, and all values but one
  CHECK(flooded.after_the_flood() == Lines{"lost " + std::to_string(lost), "Battery " + std::to_string(rounds % 100)});
}

TEST_CASE("while a reader takes what threads set, every value is taken or counted as lost") {
  Inputs inputs;
  Plans plans;
  Skills skills;
  courier::Behaviour behaviour{plans, skills, {&Inputs::tell, &inputs}};
  constexpr int writers = 3, rounds = 4'000;
  std::vector<std::thread> threads;
  for (int writer = 0; writer < writers; ++writer) {
    threads.emplace_back([post = behaviour.post(), writer] {
      for (int i = 1; i <= rounds; ++i) {
        const bool taken = writer == 0 ? post.set(post::Mood::calm) : post.set(Battery{i % 100});
        if (!taken) std::abort();
      }
    });
  }
  for (int i = 0; i < 500; ++i) behaviour.step(0s);
  for (std::thread& thread : threads) thread.join();
  behaviour.step(0s);
  behaviour.step(0s);
  std::size_t taken = 0, told = 0;
  for (const std::string& line : inputs.lines) {
    if (line.starts_with("lost ")) {
      told += std::stoul(line.substr(5));
    } else {
      taken += 1;
    }
  }
  CHECK(told == behaviour.lost());
  CHECK(taken + behaviour.lost() == writers * rounds);
}

} // namespace
