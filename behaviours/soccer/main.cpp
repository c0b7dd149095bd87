// Header: behaviours/soccer/program.hpp. Test: tests/behaviours/soccer.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/servos.hpp"
#include "behaviours/soccer/program.hpp"

#ifdef SOCCER_WITH_LIVE_VIEW
#include "soccer_page.hpp"
#else
namespace director::pages {
constexpr std::string_view soccer() { return {}; }
} // namespace director::pages
#endif

int main(int count, char** values) { return program<player::Servos>(count, values, director::pages::soccer()); }
