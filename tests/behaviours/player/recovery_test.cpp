// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/recovery.hpp"
#include "runtime/hosted/trial.hpp"

#include <catch2/catch.hpp>

namespace {

using director::Reason;
using director::testing::Fares;
using director::testing::Trial;
using soccer::GetUp, soccer::LeftArm, soccer::LeftLeg, soccer::RightArm, soccer::RightLeg, soccer::RisingStep;
using Kind = director::Outcome::Kind;

template <class Context>
void limbs_are(Trial<Context>& trial, Fares fares) {
  trial.template uses<LeftLeg>(fares).template uses<RightLeg>(fares);
  trial.template uses<LeftArm>(fares).template uses<RightArm>(fares);
}

TEST_CASE("a step of the get-up takes its posture once, and ends when all four limbs are there") {
  player::Recovery recovery;
  Trial<GetUp::Tucking> tucking;
  const auto begun = tucking.run(recovery);
  CHECK(begun.count() == 4);
  CHECK(begun.data<LeftLeg>().knee == 90 * sim::degree);
  limbs_are(tucking, Fares::done);
  tucking.uses<LeftArm>(Fares::running);
  CHECK(!tucking.reasons(Reason::subtask_done).run(recovery).sets<RisingStep>());
  tucking.uses<LeftArm>(Fares::done);
  CHECK(tucking.reasons(Reason::subtask_done).run(recovery).sets(RisingStep::tucked));
}

TEST_CASE("the last step of the get-up leaves the robot unsteady, and is done") {
  player::Recovery recovery;
  Trial<GetUp::Rising> rising;
  rising.run(recovery);
  CHECK(rising.reasons(Reason::subtask_done).run(recovery).outcome() == Kind::keep);
  limbs_are(rising, Fares::done);
  const auto answer = rising.reasons(Reason::subtask_done).run(recovery);
  CHECK(answer.outcome() == Kind::done);
  CHECK(answer.sets(soccer::Stability::unstable));
}

} // namespace
