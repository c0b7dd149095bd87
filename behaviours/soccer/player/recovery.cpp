// Header: behaviours/soccer/player/recovery.hpp. Test: tests/behaviours/soccer.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/recovery.hpp"

namespace player {

using director::Outcome;
using director::Reason;
using sim::degree;
using soccer::Brace;
using soccer::GetUp;
using soccer::LeftArm;
using soccer::LeftLeg;
using soccer::RightArm;
using soccer::RightLeg;
using soccer::RisingStep;
using soccer::Stability;

namespace {

template <class Run>
Outcome take(Run& run, sim::Angle knees, sim::Angle arms) {
  const soccer::LegMove legs{.hip = 0, .knee = knees, .ankle = 0};
  return run.request(LeftLeg{legs}, RightLeg{legs}, LeftArm{{arms}}, RightArm{{arms}});
}

template <class Run>
bool all_there(const Run& run) {
  return run.template uses<LeftLeg>().done() && run.template uses<RightLeg>().done() &&
         run.template uses<LeftArm>().done() && run.template uses<RightArm>().done();
}

} // namespace

Outcome Recovery::provide(Brace::Default& run) { return take(run, 30 * degree, 60 * degree); }

// Each step of the get-up takes its posture and, when all four limbs are there, sets RisingStep; that makes the next
// step's `when` true and its own false.

Outcome Recovery::provide(GetUp::Tucking& run) {
  if (run.reasons().has(Reason::new_task)) return take(run, 90 * degree, 0);
  if (all_there(run)) run.set(RisingStep::tucked);
  return run.keep();
}

Outcome Recovery::provide(GetUp::Pushing& run) {
  if (run.reasons().has(Reason::new_task)) return take(run, 90 * degree, 90 * degree);
  if (all_there(run)) run.set(RisingStep::kneeling);
  return run.keep();
}

Outcome Recovery::provide(GetUp::Rising& run) {
  if (run.reasons().has(Reason::new_task)) return take(run, 0, 0);
  if (!all_there(run)) return run.keep();
  run.set(Stability::unstable);
  return run.done();
}

} // namespace player
