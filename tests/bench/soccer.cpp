// Header: tests/bench/workload.hpp. Test: tests/bench/workload_test.cpp.
// SPDX-License-Identifier: MIT
//
// behaviours/soccer plays in its own world: a step of the player, with sensors and bodies.
#include "behaviours/soccer/player/player.hpp"
#include "behaviours/soccer/player/servos.hpp"
#include "behaviours/soccer/world/world.hpp"
#include "tests/bench/workload.hpp"

namespace bench {

namespace {

class Soccer final : public Playing {
public:
  Soccer(std::size_t, std::uint64_t seed, director::Observer observer) : world_(seed), player_(world_, observer) {}
  void prepare() override { world_.step(); }
  void take() override { player_.step(); }

private:
  sim::World world_;
  player::Player<player::Servos> player_;
};

} // namespace

void add_soccer(std::vector<Workload>& workloads) {
  workloads.push_back({.name = "soccer",
                       .title = "behaviours/soccer in its own world, a step",
                       .aim = "350",
                       .make = play<Soccer>,
                       .seeds = 3,
                       .inputs = 60'000,
                       .counted = 6'000});
}

} // namespace bench
