#pragma once
// SPDX-License-Identifier: MIT
// The floor: code that a programmer could write for this robot alone. It makes the same provider calls and writes in
// the same order as Director, with a switch over the inputs and function pointers, and without any decision.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

struct Robot {
  using Provider = void (*)(Robot& robot, std::size_t self);

  std::vector<Provider> providers;
  std::vector<std::uint8_t> requested; ///< by task
  std::vector<std::size_t> holder;     ///< by task
  std::vector<int> states;
  std::size_t turn = 0;
  std::uint64_t calls = 0;
};

enum class Input { nothing, set, again, all, steal, kick };

/// `count` tasks; each provider requests the next task.
Robot build_by_hand(std::size_t count);

void take(Robot& robot, Input input, std::size_t which);

/// The floor of a step that finds nothing to do: a virtual call of an empty function.
class Idler {
public:
  virtual ~Idler() = default;
  virtual void step() = 0;
};
/// Its class is not visible, so that callers cannot know the function at compile time.
Idler& idler();

} // namespace bench
