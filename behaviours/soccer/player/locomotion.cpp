// Header: behaviours/soccer/player/locomotion.hpp. Test: tests/behaviours/soccer.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/locomotion.hpp"

#include <chrono>

namespace player {

using director::Outcome;
using director::Reason;
using director::RunState;
using sim::degree;
using soccer::LeftArm;
using soccer::LeftLeg;
using soccer::RightArm;
using soccer::RightLeg;
using soccer::Stability;
using soccer::Walk;
using namespace std::chrono_literals;

namespace {

constexpr soccer::LegMove swing{.hip = 15 * degree, .knee = 30 * degree, .ankle = 15 * degree};
constexpr soccer::LegMove carry{.hip = -15 * degree, .knee = 0, .ankle = -15 * degree};
constexpr soccer::LegMove stand{};

/// A step that has begun is finished before the next one, whatever the orders are by then.
template <class Run>
bool in_mid_step(const Run& run) {
  const auto moves = [](const auto& leg) { return leg.state() == RunState::running && !leg.done(); };
  return moves(run.template uses<LeftLeg>()) || moves(run.template uses<RightLeg>());
}

} // namespace

void Locomotion::start(Walk::Start&) {
  robot_.engage();
  together_ = false;
}

void Locomotion::stop(Walk::Stop&) { robot_.release(); }

Outcome Locomotion::provide(Walk::Walking& run) {
  const soccer::WalkCommand& order = run.task();
  run.set(Stability::unstable);
  robot_.stride(order.stride);
  together_ = false;
  if (run.reasons().has(Reason::new_task)) steps_ = 0;
  if (in_mid_step(run)) return run.keep();
  if (order.steps > 0 && steps_ == order.steps) return run.done();
  ++steps_;
  left_swings_ = !left_swings_;
  const sim::Angle arms = left_swings_ ? 20 * degree : -20 * degree;
  return run.request(LeftLeg{left_swings_ ? swing : carry}, RightLeg{left_swings_ ? carry : swing}, LeftArm{{-arms}},
                     RightArm{{arms}});
}

Outcome Locomotion::provide(Walk::Halting& run) {
  if (in_mid_step(run)) return run.keep();
  robot_.stride({});
  if (!together_) {
    together_ = true;
    return run.request(LeftLeg{stand}, RightLeg{stand});
  }
  if (robot_.still()) {
    run.set(Stability::standing);
  } else {
    run.wait(50ms);
  }
  return run.keep();
}

} // namespace player
