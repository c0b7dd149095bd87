// Door: behaviours/soccer/program.hpp. Test: tests/behaviours/soccer.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/legs.hpp"
#include "behaviours/soccer/program.hpp"

int main(int count, char** values) { return program<player::Legs>(count, values); }
