// With what the board support offers, here that of tests/arm/target.
#include "say.hpp"
#include "tests/arm/target/board.hpp"

void say(const char* text) { target::print(text); }
