// Uses the board support, here that of tests/system/arm/target.
#include "say.hpp"
#include "tests/system/arm/target/board.hpp"

void say(const char* text) { target::print(text); }
