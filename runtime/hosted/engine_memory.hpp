#pragma once
// The memory of an engine whose tables are known only while running, from the heap, taken once. Generated code has it
// in its Behaviour and does not need this.

#include "runtime/core/recall.hpp"
#include "runtime/core/state.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace director {

class EngineMemory {
public:
  /// Is there also memory of what was decided before?
  enum class Recalls : bool { no, yes };

  explicit EngineMemory(const Tables& tables, Recalls recalls = Recalls::yes)
      : state_(State::bytes(Shape::of(tables)) / sizeof(std::uint64_t)),
        recall_(recalls == Recalls::yes ? Recall::bytes(tables) / sizeof(std::uint64_t) : 0) {}

  /// What an engine is built with, aligned to 8.
  std::span<std::byte> state() { return std::as_writable_bytes(std::span(state_)); }
  std::span<const std::byte> state() const { return std::as_bytes(std::span(state_)); }
  std::span<std::byte> recall() { return std::as_writable_bytes(std::span(recall_)); }

private:
  std::vector<std::uint64_t> state_, recall_;
};

} // namespace director
