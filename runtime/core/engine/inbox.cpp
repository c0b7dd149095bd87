// docs/semantics.md, section 3, Inputs: the queue of posted inputs.
// SPDX-License-Identifier: MIT
//
// The sequence number of a cell says who may use it: if it equals a writer's position, that writer; one more, the
// reader of that position. The reader frees cells in order, so if the last cell of a claim is free, all are. A writer
// publishes its records from the last to the first: a reader that sees the first sees the whole input.

#include "runtime/core/engine/inbox.hpp"

namespace director {

Inbox::Inbox(std::span<Cell> cells, std::span<OverflowSlot> slots) : cells_(cells), slots_(slots) {
  for (std::uint32_t i = 0; i < cells_.size(); ++i) cells_[i].sequence.store(i, std::memory_order_relaxed);
}

bool Inbox::post(std::span<const Input> records) {
  if (claim(records)) return true;
  count_lost();
  return false;
}

/// Writes the records of one input. False: there is no room.
bool Inbox::claim(std::span<const Input> records) {
  const auto count = static_cast<std::uint32_t>(records.size());
  const auto mask = static_cast<std::uint32_t>(cells_.size() - 1);
  if (count == 0 || count > cells_.size()) return count == 0;
  std::uint32_t at = tail_.load(std::memory_order_relaxed);
  for (;;) {
    const std::uint32_t last = at + count - 1;
    const auto lag = static_cast<std::int32_t>(cells_[last & mask].sequence.load(std::memory_order_acquire) - last);
    if (lag < 0) return false;
    if (lag > 0) {
      at = tail_.load(std::memory_order_relaxed); // another writer was faster
    } else if (tail_.compare_exchange_weak(at, at + count, std::memory_order_release, std::memory_order_relaxed)) {
      break;
    }
  }
  for (std::uint32_t i = count; i-- > 0;) {
    Cell& cell = cells_[(at + i) & mask];
    cell.input = records[i];
    cell.sequence.store(at + i + 1, std::memory_order_release);
  }
  return true;
}

bool Inbox::put(const Input& record, Index slot) {
  if (slot >= slots_.size()) return post({&record, 1});
  if (!is_pending(slot) && claim({&record, 1})) return true;
  OverflowSlot::Note note{.input = record, .leader = slot};
  note.input.handle = reserve(slot);
  if (note.input.handle == nil) return true;
  note.position = tail_.load(std::memory_order_relaxed);
  note.ticket = count(tickets_);
  publish(slot, note);
  return true;
}

const Input* Inbox::take_posted() {
  if (taken_ != nullptr) release();
  closed_ = (held_count_ == 0 || !take_slot()) && (head_ == limit_ || !take_cell());
  return closed_ ? nullptr : &record_;
}

bool Inbox::take_cell() {
  const auto size = static_cast<std::uint32_t>(cells_.size());
  Cell& cell = cells_[head_ & (size - 1)];
  if (cell.sequence.load(std::memory_order_acquire) != head_ + 1) return false;
  record_ = cell.input;
  cell.sequence.store(head_ + size, std::memory_order_release);
  ++head_;
  return true;
}

} // namespace director
