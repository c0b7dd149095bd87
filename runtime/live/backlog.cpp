// Header: runtime/live/backlog.hpp. Test: tests/runtime/live/feed_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/live/backlog.hpp"

#include <algorithm>
#include <utility>

namespace director::live {

void Backlog::add(Block block) {
  end_ = block.end;
  bytes_ += block.text->size();
  blocks_.push_back(std::move(block));
  while (bytes_ > most_ && blocks_.size() > 1) {
    bytes_ -= blocks_.front().text->size();
    blocks_.pop_front();
  }
}

const Block* Backlog::from(std::uint64_t event) const {
  const auto found =
      std::partition_point(blocks_.begin(), blocks_.end(), [&](const Block& each) { return each.begin < event; });
  return found == blocks_.end() ? nullptr : &*found;
}

const Block* Backlog::at(std::uint64_t event) const {
  const Block* const found = from(event);
  return found != nullptr && found->begin == event ? found : nullptr;
}

} // namespace director::live
