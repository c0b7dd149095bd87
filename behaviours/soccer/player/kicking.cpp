// Header: behaviours/soccer/player/kicking.hpp. Test: tests/behaviours/soccer.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/kicking.hpp"

namespace player {

using director::Outcome;
using director::Reason;
using director::RunState;
using sim::degree;
using soccer::Kick;
using soccer::LeftLeg;
using soccer::LegMove;
using soccer::RightLeg;

Outcome Kicking::provide(Kick::Default& run) {
  const bool both_there = run.uses<LeftLeg>().done() && run.uses<RightLeg>().done();
  if (run.reasons().has(Reason::new_task)) {
    stage_ = Stage::back;
  } else if (!both_there) {
    return run.keep();
  } else if (stage_ == Stage::down) {
    return run.done();
  } else {
    stage_ = stage_ == Stage::back ? Stage::through : Stage::down;
  }
  if (stage_ == Stage::through) run.set(soccer::Stability::unstable);
  const sim::Angle knee = stage_ == Stage::back ? 60 * degree : stage_ == Stage::through ? -30 * degree : 0;
  const LegMove kicks{.hip = 0, .knee = knee, .ankle = 0}, supports{};
  const bool left = run.task().leg == soccer::Side::left;
  return run.request(LeftLeg{left ? kicks : supports}, RightLeg{left ? supports : kicks});
}

} // namespace player
