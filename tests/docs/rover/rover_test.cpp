// SPDX-License-Identifier: MIT
// The rover of the pages: a whole program around tests/docs/rover/rover.yaml.
#include "rover.hpp"
#include "runtime/hosted/trial.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

using namespace std::chrono_literals;

namespace {

using director::Outcome;
using director::Reason;

class Mission final : public rover::Mission {
public:
  Outcome provide(rover::Explore::Default& run) override {
    return run.request(rover::Drive{{.degrees = 0, .mm_per_s = 200}});
  }
  Outcome provide(rover::Photograph::Default& run) override {
    if (run.uses<rover::Camera>().done()) return run.done();
    return run.request(rover::Wheels{{.left = 0, .right = 0}}, rover::Camera{});
  }
};

class Chassis final : public rover::Chassis {
public:
  void stop(rover::Drive::Stop&) override { stops_ += 1; }

  Outcome provide(rover::Drive::Rolling& run) override {
    run.set(rover::Motion::rolling);
    const int speed = run.task().mm_per_s;
    return run.request(rover::Wheels{{.left = speed, .right = speed}});
  }

  Outcome provide(rover::Drive::Braking& run) override {
    if (speed_ == 0) {
      run.set(rover::Motion::still);
      return run.keep();
    }
    run.wait(100ms); // look again
    return run.request(rover::Wheels{{.left = speed_ / 2, .right = speed_ / 2}});
  }

  Outcome provide(rover::Wheels::Default& run) override {
    speed_ = run.task().left;
    return run.keep();
  }

  Outcome provide(rover::Camera::Default& run) override {
    speed_at_picture_ = speed_;
    return run.done();
  }

  int stops_ = 0, speed_ = 0, speed_at_picture_ = -1;
};

struct Log {
  static void tell(void* self, const director::Event& event) {
    if (event.kind != director::Event::Kind::push) return;
    static_cast<Log*>(self)->lines.push_back(std::string(rover::names::group(event.group)) + " is pushed to " +
                                             rover::names::provider(event.provider) + ", to make true that " +
                                             rover::names::condition(event.condition));
  }
  std::vector<std::string> lines;
};

} // namespace

TEST_CASE("the rover of the pages stands still when it takes its picture, and drives on") {
  Mission mission;
  Chassis chassis;
  Log log;
  rover::Behaviour behaviour{mission, chassis, {Log::tell, &log}};

  behaviour.request<rover::Explore>();
  behaviour.step(0s);
  CHECK(chassis.speed_ == 200);

  std::thread button{[post = behaviour.post()] { post.request<rover::Photograph>(); }};
  button.join();
  for (auto now = 10ms; now < 2s; now += 10ms) behaviour.step(now);

  CHECK(log.lines == std::vector<std::string>{"Drive is pushed to braking, to make true that Motion == still"});
  CHECK(chassis.speed_at_picture_ == 0);
  CHECK(chassis.stops_ == 1);
  CHECK(chassis.speed_ == 200);
  CHECK(behaviour.state<rover::Photograph>() == director::RunState::none);
}

TEST_CASE("a rover that brakes halves its speed, and reports when it stands") {
  Chassis chassis;
  chassis.speed_ = 200;
  director::testing::Trial<rover::Drive::Braking> braking{rover::Course{.degrees = 0, .mm_per_s = 200}};

  const auto first = braking.reasons(Reason::pushed).run(chassis);
  CHECK(first.data<rover::Wheels>().left == 100);
  CHECK(first.wait() == 100ms);
  CHECK(!first.sets<rover::Motion>());

  chassis.speed_ = 0;
  const auto second = braking.reasons(Reason::wait).run(chassis);
  CHECK(second.outcome() == Outcome::Kind::keep);
  CHECK(second.sets(rover::Motion::still));
}

TEST_CASE("the rover of the pages reports why it takes no picture, also to another thread") {
  Mission mission;
  Chassis chassis;
  rover::Behaviour behaviour{mission, chassis};
  behaviour.request<rover::Explore>();
  behaviour.step(0s);
  CHECK(behaviour.enable<rover::Drive::Braking>(false));
  behaviour.request<rover::Photograph>();
  behaviour.step(1s);

  char buffer[200];
  const std::string words = rover::names::why(behaviour.why<rover::Photograph>(), buffer);
  CHECK(words == "Photograph waits (root>Photograph): until Motion == still, which no enabled provider promises");

  bool rolling = false;
  rover::Behaviour::Snapshot snapshot;
  behaviour.show(snapshot); // by the thread that steps, for instance after each step
  std::thread([&] {
    if (const auto look = snapshot.look()) rolling = (*look).state<rover::Explore>() == director::RunState::running;
  }).join();
  CHECK(rolling);
}
