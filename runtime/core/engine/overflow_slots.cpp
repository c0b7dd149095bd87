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

/// Gives a place that is in the one state the other, and returns it; nil: there is none.
Index Inbox::move(OverflowSlot& slot, PlaceState from, PlaceState to) {
  Index place = nil;
  change(slot.states, [&](std::uint32_t now) {
    place = OverflowSlot::find(now, from);
    return place == nil ? now : OverflowSlot::with(now, place, to);
  });
  return place;
}

void Inbox::free(OverflowSlot& slot, Index place) {
  change(slot.states, [&](std::uint32_t now) { return OverflowSlot::with(now, place, PlaceState::free); });
}

/// Reserves a handle for a record in this slot and its data, which only the caller has until it publishes. Nil: no
/// place is left, because other writers are active; their records count as the later ones.
Index Inbox::reserve(Index slot) {
  Index place = move(slots_[slot], PlaceState::free, PlaceState::filling);
  if (place == nil) {
    place = move(slots_[slot], PlaceState::published, PlaceState::filling); // it is about to be replaced
    if (place == nil) return count_lost(), nil;
    count_replaced(slots_[slot].notes[place].ticket);
  }
  return static_cast<Index>(waiting_requests + place);
}

/// Publishes a record in the reserved place, as the newest one of the slot.
void Inbox::publish(Index slot, const OverflowSlot::Note& note) {
  const auto place = static_cast<Index>(note.input.handle - waiting_requests);
  slots_[slot].notes[place] = note;
  Index last = nil;
  change(slots_[slot].states, [&](std::uint32_t now) { // at once: the reader always finds one of the two
    last = OverflowSlot::find(now, PlaceState::published);
    if (last != nil) now = OverflowSlot::with(now, last, PlaceState::filling);
    return OverflowSlot::with(now, place, PlaceState::published);
  });
  if (last != nil) lose(slots_[slot], last); // the later one counts
  unseen_.store(1, std::memory_order_release);
}

bool Inbox::post_in_turn(std::span<const Input> records) {
  return !any(records, [&](const Input& record) { return is_pending(record.thing); }) && claim(records);
}

void Inbox::reserve(std::span<Input> records) {
  for (std::size_t i = 0; i < records.size(); ++i) {
    const Index slot = records[i].thing; // of two requests for one task, the last one counts
    const bool again = any(records.subspan(i + 1), [&](const Input& later) { return later.thing == slot; });
    records[i].handle = !again && slot < slots_.size() ? reserve(slot) : nil;
  }
}

void Inbox::publish(std::span<const Input> records) {
  const std::uint32_t position = tail_.load(std::memory_order_relaxed), ticket = count(tickets_);
  Index leader = nil;
  for (const Input& record : records) {
    if (record.handle != nil && leader == nil) leader = record.thing;
  }
  for (std::size_t i = records.size(); i-- > 0;) {
    if (records[i].handle == nil) continue;
    OverflowSlot::Note note{records[i], position, ticket, leader};
    note.input.more = records.size() > 1;
    publish(records[i].thing, note);
  }
}

/// Counts a lost input, for the reader to see.
void Inbox::count_lost() {
  count(lost_);
  unseen_.store(1, std::memory_order_release);
}

void Inbox::lose(OverflowSlot& slot, Index place) {
  count_replaced(slot.notes[place].ticket);
  free(slot, place);
}

/// Counts an input of which a record was replaced, once for all of its records: these are mostly replaced together.
void Inbox::count_replaced(std::uint32_t ticket) {
  if (replaced_.load(std::memory_order_relaxed) == ticket) return;
  replaced_.store(ticket, std::memory_order_relaxed);
  count(lost_); // the reader knows, or sees the record that took its place
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
    if (taken_ == &slot) release();
    const Index place = move(slot, PlaceState::published, PlaceState::held);
    if (place == nil) continue; // a writer took it back to replace it
    if (slot.held == nil) {
      ++held_count_;
    } else { // the later one counts
      lose(slot, slot.held);
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
    if (slot.held == nil || precedes(head_, slot.held_note().position)) continue;
    if (first == nullptr || precedes(slot.held_note().ticket, first->held_note().ticket)) first = &slot;
  }
  if (first != nullptr) deliver(*first);
  return first != nullptr;
}

/// Takes the record of the slot. Its place stays held until the next one is taken, so that its data can be moved.
void Inbox::deliver(OverflowSlot& slot) {
  if (taken_ != nullptr) release();
  taken_ = &slot;
  --held_count_;
  record_ = slot.held_note().input;
  if (record_.more) record_.more = first_of(slot.held_note().ticket) != nullptr;
}

/// Frees the place of the record that was taken.
void Inbox::release() {
  free(*taken_, taken_->held);
  taken_->held = nil;
  taken_ = nullptr;
}

} // namespace director
