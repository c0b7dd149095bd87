#pragma once
// SPDX-License-Identifier: MIT
// The memory of an engine whose tables are known only while running, from the heap, taken once. Generated code has it
// in its Behaviour and does not need this.

#include "runtime/core/base/state.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace director {

/// As many bytes as the tables need, aligned as the engine wants them.
class EngineMemory {
public:
  /// From the heap, zero.
  explicit EngineMemory(const Tables& tables) : state_(lines(State::bytes(Shape::of(tables)))) {}

  /// What an engine is built with.
  std::span<std::byte> state() { return std::as_writable_bytes(std::span(state_)); }
  /// For who compares or copies it.
  std::span<const std::byte> state() const { return std::as_bytes(std::span(state_)); }

private:
  struct alignas(State::alignment) Line {
    std::byte bytes[State::alignment] = {};
  };
  static std::size_t lines(std::size_t bytes) { return (bytes + sizeof(Line) - 1) / sizeof(Line); }

  std::vector<Line> state_;
};

} // namespace director
