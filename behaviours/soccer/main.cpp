// Door: behaviours/soccer/program.hpp. Test: tests/behaviours/soccer.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/servos.hpp"
#include "behaviours/soccer/program.hpp"

int main(int count, char** values) { return program<player::Servos>(count, values); }
