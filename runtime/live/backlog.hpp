#pragma once
// SPDX-License-Identifier: MIT
// The events of the last seconds or minutes, as they are sent, once for all viewers: consecutive complete blocks. Their
// total size is bounded; a viewer whose next block is gone has missed events.

#include <cstdint>
#include <deque>
#include <memory>
#include <string>

namespace director::live {

struct Block {
  std::uint64_t begin = 0, end = 0; ///< events, counted from 0
  std::shared_ptr<const std::string> text;
};

class Backlog {
public:
  explicit Backlog(std::size_t bytes) : most_(bytes) {}

  /// Adds a block, which begins where the last one ends, or later if events were dropped between.
  void add(Block block);

  void clear() {
    blocks_.clear();
    bytes_ = 0;
  }

  /// Events before this one were dropped, up to the last block.
  void skip_to(std::uint64_t event) { end_ = event; }

  /// The block that begins there; null: none does.
  const Block* at(std::uint64_t event) const;
  /// The first block that begins there or later; null: none does.
  const Block* from(std::uint64_t event) const;
  /// The oldest event that is kept; `end()` if there is none.
  std::uint64_t begin() const { return blocks_.empty() ? end_ : blocks_.front().begin; }
  /// The number behind that of the last event.
  std::uint64_t end() const { return end_; }
  /// Whether a viewer can continue at this event.
  bool continues_at(std::uint64_t event) const { return event == end_ || at(event) != nullptr; }

private:
  std::deque<Block> blocks_;
  std::size_t most_, bytes_ = 0;
  std::uint64_t end_ = 0;
};

} // namespace director::live
