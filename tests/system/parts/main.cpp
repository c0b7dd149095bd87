// Header: this program. Test: tests/system/parts/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// Drives a behaviour by random inputs at random times, saves and loads it, and stops it. It fails by a crash, by never
// coming to rest, or if it does not load what it saved.
#include BEHAVIOUR_HEADER
#include "bodies.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

int main() {
  using director::Index;
  Bodies bodies;
  BEHAVIOUR::Behaviour behaviour{bodies};
  const auto post = behaviour.post();
  const director::Tables& tables = BEHAVIOUR::detail::Whole::tables();
  std::mt19937 random(1);
  const auto below = [&](std::size_t count) { return static_cast<Index>(random() % count); };
  std::chrono::microseconds now{0};
  bool busy = false, is_loaded = true;
  std::vector<std::byte> saved(BEHAVIOUR::Behaviour::saved_bytes());
  const auto step = [&] {
    now += std::chrono::milliseconds(below(300));
    busy = busy || behaviour.step(now) == director::StepResult::budget_exhausted;
  };
  for (int i = 0; i < 5000; ++i) {
    const Index edge = below(tables.root_edges);
    const Index kind = below(10);
    if (kind < 4 && !tables.states.empty()) {
      static_cast<void>(post.set_row(below(tables.states.size()), static_cast<std::int32_t>(below(3))));
    } else if (kind < 8) {
      static_cast<void>(post.request_row(edge, tables.edges[edge].levels.begin));
    } else {
      post.cancel_row(edge);
    }
    if (below(3) != 0) step();
    if (i % 20 == 0 && behaviour.save(saved) == director::SaveResult::saved)
      is_loaded = is_loaded && behaviour.load(saved, now) == director::LoadResult::loaded;
  }
  behaviour.cancel_all();
  for (int i = 0; i < 100; ++i) step();
  return busy || !is_loaded ? 1 : 0;
}
