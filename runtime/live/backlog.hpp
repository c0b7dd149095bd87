#pragma once
// SPDX-License-Identifier: MIT
// The events of the last seconds or minutes, as they are sent, once for all viewers: blocks one behind another, each of
// them whole. How much is kept is bounded; a viewer whose next block is gone has missed something.

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

  /// Begins where the one before ends; later, where events were dropped between.
  void add(Block block);

  /// The block that begins there; null: none does.
  const Block* at(std::uint64_t event) const;
  /// The first that begins there or later; null: none does.
  const Block* from(std::uint64_t event) const;
  /// The oldest event that is kept; `end()` where there is none.
  std::uint64_t begin() const { return blocks_.empty() ? end_ : blocks_.front().begin; }
  /// One more than the last event.
  std::uint64_t end() const { return end_; }
  /// A viewer may go on at this event.
  bool continues_at(std::uint64_t event) const { return event == end_ || at(event) != nullptr; }

private:
  std::deque<Block> blocks_;
  std::size_t most_, bytes_ = 0;
  std::uint64_t end_ = 0;
};

} // namespace director::live
