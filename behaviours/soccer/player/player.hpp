#pragma once
// SPDX-License-Identifier: MIT
// Shape: one player: its modules, its behaviour and its senses, in a world. `Legs` is the module of the deployment's
// legs.

#include "behaviours/soccer/player/kicking.hpp"
#include "behaviours/soccer/player/limbs.hpp"
#include "behaviours/soccer/player/locomotion.hpp"
#include "behaviours/soccer/player/looking.hpp"
#include "behaviours/soccer/player/planning.hpp"
#include "behaviours/soccer/player/recovery.hpp"
#include "behaviours/soccer/player/safety.hpp"
#include "behaviours/soccer/player/senses.hpp"
#include "behaviours/soccer/player/strategy.hpp"

#include <chrono>

namespace player {

template <class Legs>
class Player {
public:
  explicit Player(sim::World& world, director::Observer observer = {})
      : world_(world),
        senses_(world),
        locomotion_(world.robot()),
        planning_(world.robot()),
        strategy_(world.robot()),
        limbs_(world.robot()),
        legs_(world.robot()),
        behaviour_(recovery_, safety_, locomotion_, kicking_, looking_, planning_, strategy_, limbs_, legs_, observer) {
    behaviour_.template request<soccer::FallRecovery>();
    behaviour_.template request<soccer::Striker>();
  }

  /// Once for each tick of the world.
  void step() {
    senses_.tell(behaviour_);
    behaviour_.step(std::chrono::milliseconds(world_.now()));
  }

  const soccer::Behaviour& behaviour() const { return behaviour_; }

private:
  sim::World& world_;
  Senses senses_;
  Recovery recovery_;
  Safety safety_;
  Locomotion locomotion_;
  Kicking kicking_;
  Looking looking_;
  Planning planning_;
  Strategy strategy_;
  Limbs limbs_;
  Legs legs_;
  soccer::Behaviour behaviour_;
};

} // namespace player
