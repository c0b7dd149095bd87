// Header: behaviours/soccer/chase_ball.yaml. Test: tests/behaviours/soccer.
// SPDX-License-Identifier: MIT
// A whole program around the smallest behaviour: one class with its bodies, one root task, one loop.
#include "chase_ball.hpp"

#include "behaviours/soccer/world/geometry.hpp"

#include <chrono>
#include <cstdio>
#include <tuple>

namespace {

using director::Outcome;
using sim::degree;

/// A cart on two wheels, a ball that lies somewhere, and a camera that sees what is ahead.
struct Yard {
  sim::Point cart{0, 0}, ball{-1200, 700};
  sim::Angle heading = 0;
  chase_ball::WheelSpeeds wheels;

  sim::Angle to_ball() const { return sim::wrapped(bearing(ball - cart) - heading); }
  bool sees_ball() const { return to_ball() < 25 * degree && to_ball() > -25 * degree; }
  void pass_100_ms() {
    heading = sim::wrapped(heading + (wheels.right - wheels.left) * 2);
    cart = cart + sim::turned({(wheels.left + wheels.right) / 20, 0}, heading);
  }
};

class Cart final : public chase_ball::Cart {
public:
  explicit Cart(Yard& yard) : yard_(yard) {}

  Outcome provide(chase_ball::ChaseBall::Driving& run) override {
    const int off = yard_.to_ball() / 10;
    return run.request(chase_ball::Wheels{{.left = 300 - off, .right = 300 + off}});
  }
  Outcome provide(chase_ball::ChaseBall::Turning& run) override {
    return run.request(chase_ball::Wheels{{.left = -300, .right = 300}});
  }
  Outcome provide(chase_ball::Wheels::Default& run) override {
    yard_.wheels = run.task();
    return run.keep();
  }

private:
  Yard& yard_;
};

} // namespace

int main() {
  using namespace std::chrono_literals;
  Yard yard;
  Cart cart{yard};
  chase_ball::Behaviour behaviour{cart};
  behaviour.request<chase_ball::ChaseBall>();
  for (auto now = 0ms; length(yard.ball - yard.cart) > 100 && now < 60s; now += 100ms) {
    if (yard.sees_ball()) std::ignore = behaviour.set(chase_ball::Ball::seen);
    std::ignore = behaviour.fire<chase_ball::Picture>();
    behaviour.step(now);
    yard.pass_100_ms();
    if (now % 500ms != 0ms) continue;
    std::printf("%4.1f s  cart at (%5d, %5d) mm, ball %4d mm away %s\n", static_cast<double>(now.count()) / 1000,
                yard.cart.x, yard.cart.y, length(yard.ball - yard.cart), yard.sees_ball() ? "ahead" : "out of sight");
  }
}
