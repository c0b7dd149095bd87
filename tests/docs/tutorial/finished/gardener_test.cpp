// SPDX-License-Identifier: MIT
// The gardener of the tutorial: its bodies, on a robot that is two numbers and a tank.
#include "gardener.hpp"

#include <catch2/catch.hpp>

#include <chrono>

using namespace std::chrono_literals;

namespace {

using director::Outcome;
using director::Reason;

class Body final : public gardener::Gardener {
public:
  Outcome provide(gardener::Tend::Returning& run) override { return run.request(gardener::Drive{0}); }
  Outcome provide(gardener::Tend::Tending& run) override {
    if (litres_ == tank) return run.rest(gardener::Blink{litres_});
    return run.move(director::keep(gardener::Drive{7}), gardener::Blink{litres_});
  }

  Outcome provide(gardener::Water::Default& run) override {
    if (run.uses<gardener::Pump>().done()) return run.done();
    return run.request(gardener::Wheels{0}, gardener::Pump{});
  }

  Outcome provide(gardener::Drive::Rolling& run) override {
    run.set(gardener::Motion::rolling);
    bed_ = run.task();
    return run.request(gardener::Wheels{300});
  }

  Outcome provide(gardener::Drive::Braking& run) override {
    if (speed_ == 0) {
      run.set(gardener::Motion::still);
      return run.keep();
    }
    run.wait(100ms); // look again
    return run.request(gardener::Wheels{speed_ / 2});
  }

  void stop(gardener::Drive::Stop& run) override { run.set(gardener::Motion::still); }

  Outcome provide(gardener::Wheels::Default& run) override {
    speed_ = run.task();
    return run.keep();
  }

  Outcome provide(gardener::Pump::Default& run) override {
    if (run.reasons().has(Reason::wait)) return run.done();
    speed_at_the_pump_ = speed_;
    litres_ += 1;
    run.wait(5s);
    return run.request();
  }

  Outcome provide(gardener::Blink::Default& run) override {
    colour_ = run.task();
    return run.keep();
  }

  static constexpr int tank = 2; // litres
  int colour_ = -1;
  int bed_ = -1, speed_ = 0, litres_ = 0, speed_at_the_pump_ = -1;
};

} // namespace

TEST_CASE("the gardener of the tutorial comes to rest, waters, and goes on") {
  Body body;
  gardener::Behaviour behaviour{body};

  behaviour.request<gardener::Tend>();
  behaviour.step(0s);
  CHECK(body.bed_ == 7);
  CHECK(body.speed_ == 300);

  behaviour.request<gardener::Water>();
  for (auto now = 10ms; now < 10s; now += 10ms) behaviour.step(now);
  CHECK(body.litres_ == 1);
  CHECK(body.speed_at_the_pump_ == 0);
  CHECK(body.speed_ == 300);
  CHECK(body.colour_ == 0);

  behaviour.step(11s); // it has looked at its tank
  CHECK(body.colour_ == 1);
  CHECK(body.speed_ == 300);

  CHECK(behaviour.set(gardener::Battery{15}));
  behaviour.step(12s);
  CHECK(body.bed_ == 0);
}
