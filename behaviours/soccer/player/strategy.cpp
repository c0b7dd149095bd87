// Header: behaviours/soccer/player/strategy.hpp. Test: tests/behaviours/soccer.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/strategy.hpp"

#include "behaviours/soccer/player/sight.hpp"

namespace player {

using director::keep;
using director::Outcome;
using director::Reason;
using sim::degree;
using soccer::KickTo;
using soccer::KickToGoal;
using soccer::Look;
using soccer::LookAt;
using soccer::Striker;
using soccer::Walk;
using soccer::WalkTo;
using soccer::WalkToBall;
using soccer::WalkToReady;

Outcome Strategy::provide(Striker::Playing& run) {
  if (run.reasons().has(Reason::new_task)) return run.attack(KickToGoal{}, WalkToBall{}, Look{});
  return run.attack(KickToGoal{}, keep(WalkToBall{}), keep(Look{})); // the ball was kicked; kick it again
}

Outcome Strategy::provide(Striker::Ready& run) {
  if (run.uses<WalkToReady>().done()) return run.stay_there(Look{});
  return run.go(WalkToReady{}, Look{});
}

Outcome Strategy::provide(Striker::Waiting& run) { return run.watch(Look{}); }

Outcome Strategy::provide(KickToGoal::Default& run) {
  if (run.reasons().has(Reason::subtask_done) && run.uses<KickTo>().done()) return run.done();
  return run.shoot(KickTo{{sim::goal}});
}

// A new place to walk to with each picture in which the ball was seen. That WalkTo has come there is no reason to move.

Outcome Strategy::provide(WalkToBall::Creeping& run) {
  if (!asks_for_new_place(run.reasons())) return run.keep();
  return run.creep(WalkTo{behind_ball(200, 35)});
}

Outcome Strategy::provide(WalkToBall::Striding& run) {
  if (!asks_for_new_place(run.reasons())) return run.keep();
  return run.stride(WalkTo{behind_ball(300, 65)});
}

Outcome Strategy::provide(WalkToBall::Searching& run) {
  const sim::Angle turn = direction_of_ball() < 0 ? -12 * degree : 12 * degree; // it was seen there last
  return run.turn(Walk{{.stride = {.turn = turn}, .steps = 0}});
}

Outcome Strategy::provide(WalkToReady::Default& run) {
  if (run.reasons().has(Reason::subtask_done) && run.uses<WalkTo>().done()) return run.done();
  return run.go(WalkTo{{.place = sim::kick_off_place, .heading = 0, .longest = 65}});
}

Outcome Strategy::provide(Look::Tracking& run) { return run.track(LookAt{{direction_of_ball()}}); }

Outcome Strategy::provide(Look::Sweeping& run) {
  sweeps_left_ = !sweeps_left_;
  return run.sweep(LookAt{{sweeps_left_ ? 60 * degree : -60 * degree}});
}

bool Strategy::asks_for_new_place(director::Reasons reasons) const {
  return reasons.has(Reason::new_task) || (reasons.has(Reason::trigger) && robot_.picture().seen);
}

sim::Angle Strategy::direction_of_ball() const { return sim::bearing(seen_from(robot_.pose(), robot_.picture().ball)); }

/// Behind the ball, with the goal ahead; from in front of the ball, round it first.
soccer::WalkTarget Strategy::behind_ball(int distance, int longest_step) const {
  const sim::Point ball = robot_.picture().ball;
  const sim::Point self = along_shot(ball, robot_.pose().place);
  const bool in_front = self.x > -80 && length(self) < 800;
  const sim::Point place = in_front ? sim::Point{-150, self.y < 0 ? -450 : 450} : sim::Point{-distance, 0};
  return {.place = beside(ball, place), .heading = shot(ball), .longest = longest_step};
}

} // namespace player
