// docs/semantics.md, section 7: what a full inbox does not refuse.
// SPDX-License-Identifier: MIT

#include "runtime/core/engine/overflow_slots.hpp"

namespace director {

namespace {

/// Is `a` before `b`? Both count round and round, and are never far apart.
bool precedes(std::uint32_t a, std::uint32_t b) { return static_cast<std::int32_t>(a - b) < 0; }

} // namespace

bool OverflowSlots::wait(Index slot) const {
  return has(slot) && any_published(slots_[slot].states.load(std::memory_order_acquire));
}

Index OverflowSlots::reserve(Index slot) {
  Index place = nil;
  const std::uint32_t before = change(slots_[slot].states, [&](std::uint32_t now) {
    place = find(now, PlaceState::free);
    if (place == nil) place = find(now, PlaceState::published); // it is about to be replaced anyway
    return place == nil ? now : with(now, place, PlaceState::filling);
  });
  if (place == nil || state_of(before, place) == PlaceState::published) count_lost();
  return place == nil ? nil : static_cast<Index>(waiting_requests + place);
}

void OverflowSlots::publish(Index slot, const Input& record, std::uint32_t position) {
  put(slot, {record, position, count(tickets_), slot});
  spoken_.store(1, std::memory_order_release);
}

/// Into the place that was reserved, which is the newest record from then on.
void OverflowSlots::put(Index slot, const Note& note) {
  const auto place = static_cast<Index>(note.input.handle - waiting_requests);
  slots_[slot].notes[place] = note;
  const std::uint32_t before = change(slots_[slot].states, [&](std::uint32_t now) {
    const Index last = find(now, PlaceState::published);
    if (last != nil) now = with(now, last, PlaceState::free);
    return with(now, place, PlaceState::published);
  });
  if (any_published(before)) count_lost();
}

void OverflowSlots::count_lost() {
  count(lost_);
  spoken_.store(1, std::memory_order_release);
}

void OverflowSlots::open() {
  std::uint32_t spoken = 1;
  if (!spoken_.compare_exchange_strong(spoken, 0, std::memory_order_acquire, std::memory_order_relaxed)) return;
  // Again until nothing is new: what was published before a record that was seen must be seen with it.
  for (std::size_t i = 0; i <= slots_.size() && sweep(); ++i) {}
  for (Slot& slot : slots_) {
    if (slot.held != nil && &slot != given_ && slot.notes[slot.held].input.more) wait_for_leader(slot);
  }
}

bool OverflowSlots::sweep() {
  bool found = false;
  for (Slot& slot : slots_) {
    if (!any_published(slot.states.load(std::memory_order_acquire))) continue;
    if (given_ == &slot) given_ = nullptr, let_go(slot);
    Index place = nil;
    change(slot.states, [&](std::uint32_t now) {
      place = find(now, PlaceState::published);
      if (place == nil) return now;                                       // a writer took it back to replace it
      if (slot.held != nil) now = with(now, slot.held, PlaceState::free); // the later one counts
      return with(now, place, PlaceState::held);
    });
    if (place == nil) continue;
    if (slot.held == nil) {
      ++in_hand_;
    } else {
      count_lost();
    }
    slot.held = place;
    found = true;
  }
  return found;
}

void OverflowSlots::let_go(Slot& slot) {
  change(slot.states, [&](std::uint32_t now) { return with(now, slot.held, PlaceState::free); });
  slot.held = nil;
}

bool OverflowSlots::take(std::uint32_t position, Input& out) {
  Slot* first = nullptr;
  for (Slot& slot : slots_) {
    if (slot.held == nil || &slot == given_) continue;
    const Note& note = slot.notes[slot.held];
    if (precedes(position, note.position)) continue;
    if (first == nullptr || precedes(note.ticket, first->notes[first->held].ticket)) first = &slot;
  }
  if (first == nullptr) return false;
  taken_ = first->notes[first->held].ticket;
  out = give(*first);
  return true;
}

/// The place stays held until the next one is given, so that the data that belong to it can be moved.
Input OverflowSlots::give(Slot& slot) {
  if (given_ != nullptr) let_go(*given_);
  given_ = &slot;
  --in_hand_;
  Input out = slot.notes[slot.held].input;
  if (out.more) out.more = first_of(slot.notes[slot.held].ticket) != nullptr;
  return out;
}

} // namespace director
