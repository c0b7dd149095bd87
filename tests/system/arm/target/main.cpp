// Header: tests/system/arm/target/board.hpp. Test: tests/system/arm/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// Plays all plans that fit into the board's memory. Lines that begin with `#` are about the program and not about a
// scenario.
#include "tests/system/arm/target/player.hpp"
#include "tests/system/arm/target/text.hpp"

#include <algorithm>

namespace {

alignas(8) std::byte memory[TARGET_MEMORY];

void tell(const char* what, std::size_t number) {
  target::Line().add("# ").add(what).add(": ").add(static_cast<std::int64_t>(number)).end();
}

} // namespace

int main() {
  target::Used most;
  std::size_t played = 0, saved = 0;
  for (const target::Plan& plan : target::plans) {
    const target::Used used = target::play(plan, memory);
    if (used.memory > sizeof memory) {
      target::Line().add("# left out: ").add(plan.title).end();
      continue;
    }
    ++played;
    saved += used.saved ? 1 : 0;
    most.state = std::max(most.state, used.state);
    most.memory = std::max(most.memory, used.memory);
  }
  tell("scenarios played", played);
  tell("of them saved and loaded between steps", saved);
  tell("bytes of the engine's memory, at most", most.state);
  tell("bytes with inbox and script, at most", most.memory);
  tell("bytes of stack, at most", target::deepest_stack());
  return 0;
}
