#pragma once
// The way in: a bounded queue of inputs with many writers and one reader, without locks and without memory of its own.
// An input may take several records (several states set at once, several root tasks): it goes in whole or not at all.
// Needs 32-bit compare-and-swap. Source: D. Vyukov's bounded queue, with several cells claimed at once.

#include "runtime/core/tables.hpp"

#include <atomic>
#include <cstdint>
#include <span>

namespace director {

struct Input {
  enum class Kind : std::uint8_t { request, cancel, set, fire, enable, disable };
  Kind kind = Kind::set;
  bool more = false;      ///< the next record belongs to the same input (request and set)
  Index thing = 0;        ///< root edge, state, trigger or provider
  Index level = 0;        ///< request: of Tables::levels
  Index handle = nil;     ///< request: where its data wait; nil: it has nil
  std::int32_t value = 0; ///< set
};

class Inbox {
public:
  struct Cell {
    std::atomic<std::uint32_t> turn{0};
    Input input;
  };

  /// `cells`: a power of two of them, at least 2; owned by the caller, who must keep them.
  explicit Inbox(std::span<Cell> cells);
  Inbox(const Inbox&) = delete;
  Inbox& operator=(const Inbox&) = delete;

  /// From any thread. The records of one input, `more` set on all but the last. False: full, and nothing went in.
  bool post(std::span<const Input> records);

  /// From the reader's thread: the next record, if one is there.
  bool take(Input& out);

  /// Records claimed by writers and not taken yet, as seen by the reader.
  std::uint32_t waiting() const { return tail_.load(std::memory_order_acquire) - head_; }
  bool empty() const { return waiting() == 0; }

private:
  std::span<Cell> cells_;
  std::atomic<std::uint32_t> tail_{0};
  std::uint32_t head_ = 0;
};

} // namespace director
