// docs/semantics.md, section 3, Inputs: inputs of several records, which are taken together.
// SPDX-License-Identifier: MIT
//
// A reader that sees a record in an overflow slot whose leader, the first record of the input, is still missing leaves
// it in its slot: Inbox::publish publishes the leader last.

#include "runtime/core/engine/inbox.hpp"

namespace director {

const char part::together = 0;

void link(std::span<Input> records) {
  for (std::size_t i = 0; i + 1 < records.size(); ++i) records[i].more = true;
}

/// The next record is there: the writer published it before the first one.
const Input* Inbox::take_more() {
  if (taken_ == nullptr) return take_cell() ? &record_ : nullptr;
  OverflowSlot* const next = first_of(taken_->held_note().ticket);
  if (next != nullptr) deliver(*next);
  return next != nullptr ? &record_ : nullptr;
}

/// Puts a record back if the rest of its input is about to be published. If a later one has come, this one is lost.
void Inbox::wait_for_leader(OverflowSlot& slot) {
  using PlaceState = OverflowSlot::PlaceState;
  const std::uint32_t ticket = slot.held_note().ticket;
  const OverflowSlot& first = slots_[slot.held_note().leader];
  if (first.held != nil && &first != taken_ && first.held_note().ticket == ticket) return;
  const std::uint32_t leading = first.states.load(std::memory_order_acquire);
  if (OverflowSlot::find(leading, PlaceState::filling) == nil && !OverflowSlot::any_published(leading)) return;
  const std::uint32_t before = change(slot.states, [&](std::uint32_t now) {
    const PlaceState next = OverflowSlot::any_published(now) ? PlaceState::free : PlaceState::published;
    return OverflowSlot::with(now, slot.held, next);
  });
  if (OverflowSlot::any_published(before)) count_replaced(ticket);
  slot.held = nil;
  --held_count_;
  unseen_.store(1, std::memory_order_relaxed);
}

OverflowSlot* Inbox::first_of(std::uint32_t ticket) {
  for (OverflowSlot& slot : slots_) {
    if (slot.held != nil && &slot != taken_ && slot.held_note().ticket == ticket) return &slot;
  }
  return nullptr;
}

} // namespace director
