// Header: behaviours/soccer/player/planning.hpp. Test: tests/behaviours/soccer.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/planning.hpp"

#include "behaviours/soccer/player/sight.hpp"

#include <chrono>
#include <cstdlib>

namespace player {

using director::keep;
using director::Outcome;
using director::Reason;
using director::RunState;
using sim::clamped;
using sim::degree;
using sim::Point;
using soccer::Kick;
using soccer::KickTo;
using soccer::LookAt;
using soccer::Walk;
using soccer::WalkTo;
using namespace std::chrono_literals;

namespace {

constexpr int foot = 180;    // a ball so far ahead lies right for a kick
constexpr int too_far = 450; // to line up from here; WalkToBall brings us nearer
constexpr int arrived = 60;

soccer::Stride stride_towards(Point way, sim::Angle off, int longest) {
  return {.forward = clamped(way.x / 3, longest),
          .left = clamped(way.y / 3, longest / 2),
          .turn = clamped(off / 3, 10 * degree)};
}

} // namespace

Outcome Planning::provide(WalkTo::Default& run) {
  const soccer::WalkTarget& target = run.task();
  const sim::Pose pose = robot_.pose();
  const Point way = seen_from(pose, target.place);
  const sim::Angle off = sim::wrapped(target.heading - pose.heading);
  const bool there = length(way) < arrived && std::abs(off) < 8 * degree;
  if (there && !run.reasons().has(Reason::new_task)) return run.done(); // marking time until somebody wants more

  run.wait(100ms); // the ground slips: plan again
  if (length(way) < 350) return run.step(Walk{{.stride = stride_towards(way, off, target.longest), .steps = 0}});
  const sim::Angle aim = bearing(way);
  const int forward = std::abs(aim) < 40 * degree ? target.longest : 0; // turn round on the spot
  return run.step(Walk{{.stride = {.forward = forward, .left = 0, .turn = clamped(aim / 3, 12 * degree)}, .steps = 0}});
}

Outcome Planning::provide(KickTo::Default& run) {
  const auto walk = run.uses<Walk>();
  const auto kick = run.uses<Kick>();
  const sim::Picture& picture = robot_.picture();
  const Point ball = seen_from(robot_.pose(), picture.ball);
  const sim::Angle off = sim::wrapped(sim::bearing(run.task().place - picture.ball) - robot_.pose().heading);
  const bool lies_right = std::abs(ball.x - foot) < 60 && std::abs(ball.y) < 80 && std::abs(off) < 12 * degree;
  const Kick order{{ball.y > 0 ? soccer::Side::left : soccer::Side::right}};
  const LookAt eyes_on_ball{{bearing(ball)}};

  // The kick is over; or it runs, or waits for the robot to stand: then it stays as it was ordered.
  if (run.reasons().has(Reason::subtask_done) && kick.done()) return run.done();
  if (kick.state() == RunState::running && !kick.done()) return run.kick(keep(order), eyes_on_ball);
  if (kick.state() == RunState::queued && lies_right) return run.kick(keep(order), eyes_on_ball);
  // Steps that have begun are finished first.
  if (walk.state() == RunState::running && !walk.done()) return run.keep();
  // Nothing goes on, or the steps are done: look where the ball is. Under a new order, wait for a new picture of it.
  if (run.reasons().has(Reason::new_task)) return run.stand_by();
  if (!picture.seen || length(ball) > too_far || std::abs(off) > 60 * degree) return run.stand_by();
  if (lies_right) return run.kick(order, eyes_on_ball);
  const Point way = ball - sim::turned({foot, 0}, off);
  return run.line_up(Walk{{.stride = stride_towards(way, off, 30), .steps = 1}});
}

} // namespace player
