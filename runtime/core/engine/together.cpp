// docs/semantics.md, section 7: inputs of several records, which are taken together.
// SPDX-License-Identifier: MIT
//
// In OverflowSlots the records of one input are published from the last to the first, the leader, and all places are
// reserved before: who sees a record whose leader is still to come leaves it where it is.

#include "runtime/core/engine/inbox.hpp"

namespace director {

namespace part {
const char together = 0;
}

void link(std::span<Input> records) {
  for (std::size_t i = 0; i + 1 < records.size(); ++i) records[i].more = true;
}

/// The writer published it before the first one.
const Input* Inbox::take_more() { return (word_ ? words_.take_more(record_) : take_cell()) ? &record_ : nullptr; }

bool Inbox::post_in_turn(std::span<const Input> records) {
  for (const Input& record : records) {
    if (words_.wait(record.thing)) return false;
  }
  return claim(records);
}

void Inbox::reserve(std::span<Input> records) {
  for (std::size_t i = 0; i < records.size(); ++i) {
    bool last = true; // asked twice, the last one counts
    for (std::size_t j = i + 1; j < records.size(); ++j) last = last && records[j].thing != records[i].thing;
    records[i].handle = last && words_.has(records[i].thing) ? words_.reserve(records[i].thing) : nil;
  }
}

void Inbox::publish(std::span<const Input> records) { words_.publish(records, tail_.load(std::memory_order_relaxed)); }

void OverflowSlots::publish(std::span<const Input> records, std::uint32_t position) {
  Index leader = nil;
  for (const Input& record : records) {
    if (record.handle != nil && leader == nil) leader = record.thing;
  }
  if (leader == nil) return;
  const std::uint32_t ticket = count(tickets_);
  for (std::size_t i = records.size(); i-- > 0;) {
    if (records[i].handle == nil) continue;
    Note note{records[i], position, ticket, leader};
    note.input.more = records.size() > 1;
    put(records[i].thing, note);
  }
  spoken_.store(1, std::memory_order_release);
}

/// Back into its slot, if the rest of its input is about to be published. A later record may have come meanwhile; then
/// this one is forgotten.
void OverflowSlots::wait_for_leader(Slot& slot) {
  const Note& note = slot.notes[slot.held];
  const Slot& first = slots_[note.leader];
  if (first.held != nil && &first != given_ && first.notes[first.held].ticket == note.ticket) return;
  const std::uint32_t leading = first.states.load(std::memory_order_acquire);
  if (find(leading, PlaceState::filling) == nil && !any_published(leading)) return;
  const std::uint32_t before = change(slot.states, [&](std::uint32_t now) {
    return with(now, slot.held, any_published(now) ? PlaceState::free : PlaceState::published);
  });
  if (any_published(before)) count_lost();
  slot.held = nil;
  --in_hand_;
  spoken_.store(1, std::memory_order_relaxed);
}

bool OverflowSlots::take_more(Input& out) {
  Slot* next = first_of(taken_);
  if (next != nullptr) out = give(*next);
  return next != nullptr;
}

OverflowSlots::Slot* OverflowSlots::first_of(std::uint32_t ticket) {
  for (Slot& slot : slots_) {
    if (slot.held != nil && &slot != given_ && slot.notes[slot.held].ticket == ticket) return &slot;
  }
  return nullptr;
}

} // namespace director
