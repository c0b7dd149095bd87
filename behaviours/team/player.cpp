// Header: behaviours/team/player.hpp. Test: tests/behaviours/team/network_test.cpp.
// SPDX-License-Identifier: MIT
#include "behaviours/team/player.hpp"

using director::Outcome;

namespace players {

namespace {

/// Whichever number it plays as.
Outcome strike(auto& run) {
  run.set(team::Role::striking);
  return run.request(team::Legs{{.cm_per_s = 50}});
}

} // namespace

Outcome Player::provide(team::Halt::Default& run) { return run.request(team::Legs{{.cm_per_s = 0}}); }

Outcome Player::provide(team::Play::Striking_as_one& run) { return strike(run); }
Outcome Player::provide(team::Play::Striking_as_two& run) { return strike(run); }
Outcome Player::provide(team::Play::Striking_as_three& run) { return strike(run); }

Outcome Player::provide(team::Play::Supporting& run) {
  run.set(team::Role::supporting);
  return run.request(team::Legs{{.cm_per_s = 10}});
}

Outcome Player::provide(team::Play::Searching& run) {
  run.set(team::Role::searching);
  return run.request(team::Legs{{.cm_per_s = 0}});
}

Outcome Player::provide(team::Legs::Default& run) {
  cm_per_s_ = run.task().cm_per_s;
  return run.keep();
}

} // namespace players
