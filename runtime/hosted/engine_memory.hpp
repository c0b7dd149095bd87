#pragma once
// SPDX-License-Identifier: MIT
// The memory of an engine whose tables are known only at run time, allocated once on the heap. Generated code has it in
// its Behaviour and does not need this.

#include "runtime/core/base/state.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace director {

/// The bytes that the tables need, aligned for the engine.
class EngineMemory {
public:
  /// Allocates the memory, all zero.
  explicit EngineMemory(const Tables& tables) : state_(lines(State::bytes(Shape::of(tables)))) {}

  /// For the constructor of an engine.
  std::span<std::byte> state() { return std::as_writable_bytes(std::span(state_)); }
  /// For comparing or copying.
  std::span<const std::byte> state() const { return std::as_bytes(std::span(state_)); }

private:
  struct alignas(State::alignment) Line {
    std::byte bytes[State::alignment] = {};
  };
  static std::size_t lines(std::size_t bytes) { return (bytes + sizeof(Line) - 1) / sizeof(Line); }

  std::vector<Line> state_;
};

} // namespace director
