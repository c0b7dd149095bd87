// docs/semantics.md, Inputs that are lost: inputs that a full inbox does not refuse.
// SPDX-License-Identifier: MIT

#include "runtime/core/engine/inbox.hpp"

namespace director {

namespace {

using PlaceState = OverflowSlot::PlaceState;

/// Whether `a` is before `b`. Both wrap around, and are never far apart.
bool precedes(std::uint32_t a, std::uint32_t b) { return static_cast<std::int32_t>(a - b) < 0; }

} // namespace

/// Whether the newest record in this slot was not seen by the reader yet.
bool Inbox::is_pending(Index slot) const {
  return slot < slots_.size() && OverflowSlot::any_published(slots_[slot].states.load(std::memory_order_acquire));
}

/// Reserves a handle for a record in this slot and its data, which only the caller has until it publishes. Nil: no
/// place is left, because other writers are active; their records count as the later ones.
Index Inbox::reserve(Index slot) {
  Index place = nil;
  const std::uint32_t before = change(slots_[slot].states, [&](std::uint32_t now) {
    place = OverflowSlot::find(now, PlaceState::free);
    if (place == nil) place = OverflowSlot::find(now, PlaceState::published); // it is about to be replaced
    return place == nil ? now : OverflowSlot::with(now, place, PlaceState::filling);
  });
  if (place == nil || OverflowSlot::state_of(before, place) == PlaceState::published) count_lost();
  return place == nil ? nil : static_cast<Index>(waiting_requests + place);
}

/// Publishes a record in the reserved place, as the newest one of the slot.
void Inbox::publish(Index slot, const OverflowSlot::Note& note) {
  const auto place = static_cast<Index>(note.input.handle - waiting_requests);
  slots_[slot].notes[place] = note;
  const std::uint32_t before = change(slots_[slot].states, [&](std::uint32_t now) {
    const Index last = OverflowSlot::find(now, PlaceState::published);
    if (last != nil) now = OverflowSlot::with(now, last, PlaceState::free);
    return OverflowSlot::with(now, place, PlaceState::published);
  });
  if (OverflowSlot::any_published(before)) count_lost();
  unseen_.store(1, std::memory_order_release);
}

/// Counts a lost input, for the reader to see.
void Inbox::count_lost() {
  count(lost_);
  unseen_.store(1, std::memory_order_release);
}

/// Holds the newest record of every slot; a record published later waits for the next call.
void Inbox::open_slots() {
  std::uint32_t unseen = 1;
  if (!unseen_.compare_exchange_strong(unseen, 0, std::memory_order_acquire, std::memory_order_relaxed)) return;
  // Repeated until no record is new: a record published before one that was seen must be seen with it.
  for (std::size_t i = 0; i <= slots_.size() && sweep(); ++i) {}
  for (OverflowSlot& slot : slots_) {
    if (slot.held != nil && &slot != taken_ && slot.held_note().input.more) wait_for_leader(slot);
  }
}

bool Inbox::sweep() {
  bool found = false;
  for (OverflowSlot& slot : slots_) {
    if (!OverflowSlot::any_published(slot.states.load(std::memory_order_acquire))) continue;
    if (taken_ == &slot) taken_ = nullptr, release(slot);
    Index place = nil;
    change(slot.states, [&](std::uint32_t now) {
      place = OverflowSlot::find(now, PlaceState::published);
      if (place == nil) return now; // a writer took it back to replace it
      if (slot.held != nil) now = OverflowSlot::with(now, slot.held, PlaceState::free); // the later one counts
      return OverflowSlot::with(now, place, PlaceState::held);
    });
    if (place == nil) continue;
    if (slot.held == nil) {
      ++held_count_;
    } else {
      count_lost();
    }
    slot.held = place;
    found = true;
  }
  return found;
}

/// Takes, of the held records that are not behind the next record of the queue, the one published first.
bool Inbox::take_slot() {
  OverflowSlot* first = nullptr;
  for (OverflowSlot& slot : slots_) {
    if (slot.held == nil || &slot == taken_ || precedes(head_, slot.held_note().position)) continue;
    if (first == nullptr || precedes(slot.held_note().ticket, first->held_note().ticket)) first = &slot;
  }
  if (first != nullptr) deliver(*first);
  return first != nullptr;
}

/// Takes the record of the slot. Its place stays held until the next one is taken, so that its data can be moved.
void Inbox::deliver(OverflowSlot& slot) {
  if (taken_ != nullptr) release(*taken_);
  taken_ = &slot;
  --held_count_;
  record_ = slot.held_note().input;
  if (record_.more) record_.more = first_of(slot.held_note().ticket) != nullptr;
}

void Inbox::release(OverflowSlot& slot) {
  change(slot.states, [&](std::uint32_t now) { return OverflowSlot::with(now, slot.held, PlaceState::free); });
  slot.held = nil;
}

} // namespace director
