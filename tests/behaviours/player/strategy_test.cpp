// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/strategy.hpp"
#include "runtime/hosted/trial.hpp"

#include <catch2/catch.hpp>

namespace {

using director::Reason;
using director::testing::Fares;
using director::testing::Trial;
using soccer::Look, soccer::Striker, soccer::WalkTo, soccer::WalkToBall, soccer::WalkToReady;

struct Bench {
  sim::Random random{1};
  sim::Robot robot{{-1000, 0}, random};
  player::Strategy strategy{robot};
};

TEST_CASE("a striker that has kicked kicks again, and leaves the rest of its attack as it is") {
  Bench bench;
  Trial<Striker::Playing> playing;
  const auto first = playing.run(bench.strategy);
  CHECK(first.pack() == "attack");
  CHECK(!first.keeps<WalkToBall>());
  const auto again = playing.reasons(Reason::subtask_done).run(bench.strategy);
  CHECK(again.pack() == "attack");
  CHECK(!again.keeps<soccer::KickToGoal>());
  CHECK(again.keeps<WalkToBall>());
  CHECK(again.keeps<Look>());
}

TEST_CASE("a striker goes to its place, and once there looks about") {
  Bench bench;
  Trial<Striker::Ready> ready;
  CHECK(ready.run(bench.strategy).pack() == "go");
  CHECK(ready.uses<WalkToReady>(Fares::done).run(bench.strategy).pack() == "stay_there");
}

TEST_CASE("close to the ball the steps are small, and only a picture with the ball is a reason to move") {
  Bench bench;
  bench.robot.see({.at = 0, .seen = true, .ball = {0, 0}});
  Trial<WalkToBall::Creeping> creeping;
  CHECK(creeping.run(bench.strategy).data<WalkTo>().longest == 35);
  CHECK(creeping.triggered<soccer::Vision>().run(bench.strategy).requests<WalkTo>());
  bench.robot.see({.at = 100, .seen = false, .ball = {0, 0}});
  CHECK(!creeping.triggered<soccer::Vision>().run(bench.strategy).requests<WalkTo>());
}

} // namespace
