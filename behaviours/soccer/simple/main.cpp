// Header: behaviours/soccer/program.hpp. Test: tests/behaviours/soccer.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/legs.hpp"
#include "behaviours/soccer/program.hpp"

#ifdef SOCCER_WITH_LIVE_VIEW
#include "soccer_simple_page.hpp"
#else
namespace director::pages {
constexpr std::string_view soccer_simple() { return {}; }
} // namespace director::pages
#endif

int main(int count, char** values) { return program<player::Legs>(count, values, director::pages::soccer_simple()); }
