#pragma once
// SPDX-License-Identifier: MIT
// The way in: a bounded queue of inputs with many writers and one reader, without locks and without memory of its own.
// An input may take several records (several states set at once, several root tasks): it goes in whole or not at all.
// What requests or cancels root tasks, or sets one state, is never refused: where the queue is full it goes by an
// overflow slot, and is taken after all that was in the queue then. What is refused, or replaced there before it was
// taken, is counted. Needs 32-bit compare-and-swap and nothing more; on a core without it the program supplies what the
// compiler calls for it (GCC: __atomic_compare_exchange_4), as a critical section. Source: D. Vyukov's bounded queue,
// with several cells claimed at once.

#include "runtime/core/base/parts.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <span>

namespace director {

/// How many requests of one root task with data can wait in the inbox at once. One more goes by an overflow slot.
inline constexpr Index waiting_requests = 4;

/// One record of what the outside says to a behaviour; an input takes one or more of them.
struct Input {
  enum class Kind : std::uint8_t { request, cancel, set, fire, enable, disable };
  Kind kind = Kind::set;
  bool more = false;  ///< the next record belongs to the same input (request and set): see link()
  Index thing = 0;    ///< root edge, state, trigger or provider; nil: cancel of all root edges
  Index handle = nil; ///< request: where its data wait: up to waiting_requests in the inbox, from there on in a place
                      ///< of an overflow slot; nil: it has none
  std::int32_t value = 0; ///< set: the value; request: the level, of Tables::levels
  Index level() const { return static_cast<Index>(value); }
  void set_level(Index level) { value = static_cast<std::int32_t>(level); }
};

/// Several records become one input.
void link(std::span<Input> records);

/// Of one root task or external state, for what finds the queue full: the last record counts. A place is free, then
/// being filled by one writer, then published (at most one in a slot, the newest record), then in the reader's hands,
/// then free again. Each step is a compare-and-swap of `states`; to publish frees the record before it in the same
/// step.
struct OverflowSlot {
  /// The newest record, one that the reader has in hand, and two that are being written.
  static constexpr Index places = 4;
  enum class PlaceState : std::uint32_t { free = 0, filling = 1, published = 2, held = 3 };
  struct Note {
    Input input;                ///< `more`: its input has several records
    std::uint32_t position = 0; ///< in the queue: what was there before is taken before
    std::uint32_t ticket = 0;   ///< later inputs have higher ones; records of one input have the same
    Index leader = 0;           ///< the slot of that record of the input which is published last
  };

  static PlaceState state_of(std::uint32_t states, Index place) {
    return static_cast<PlaceState>(states >> (2 * place) & 3U);
  }
  static std::uint32_t with(std::uint32_t states, Index place, PlaceState state) {
    return (states & ~(3U << (2 * place))) | static_cast<std::uint32_t>(state) << (2 * place);
  }
  static Index find(std::uint32_t states, PlaceState state) {
    for (Index place = 0; place < places; ++place) {
      if (state_of(states, place) == state) return place;
    }
    return nil;
  }
  static bool any_published(std::uint32_t states) { return (states >> 1 & ~states & 0x55U) != 0; }
  const Note& in_hand() const { return notes[held]; }

  std::atomic<std::uint32_t> states{0}; ///< two bits a place
  std::array<Note, places> notes;
  Index held = nil; ///< the reader's: the place that it has in hand
};

class Inbox {
public:
  struct Cell {
    std::atomic<std::uint32_t> sequence{0};
    Input input;
  };

  /// `cells`: a power of two of them, at least 2. `slots`: one for each root edge, then one for each other that `put`
  /// names; without them a full inbox refuses everything. Both are owned by the caller, who must keep them.
  explicit Inbox(std::span<Cell> cells, std::span<OverflowSlot> slots = {});
  Inbox(const Inbox&) = delete;
  Inbox& operator=(const Inbox&) = delete;

  // For writers: any thread.

  /// The records of one input, `more` set on all but the last. False: full, nothing went in, and the input is lost.
  bool post(std::span<const Input> records);
  /// An input of one record, without data, that has an overflow slot: it is not refused.
  bool put(const Input& record, Index slot);

  // Requests of root tasks that are several or have data are not refused either. Their edges are their slots.
  /// False: it is full, or a request or cancel of one of these tasks waits outside, and this one must wait behind it.
  bool post_in_turn(std::span<const Input> records);
  /// Reserves a place of an overflow slot for each record, as its handle: there its data go before they are published.
  /// Nil: this record does not count, as a later one about the same root task does.
  void reserve(std::span<Input> records);
  void publish(std::span<const Input> records);

  /// Inputs that were refused or replaced so far; from any thread.
  std::uint32_t lost() const { return lost_.load(std::memory_order_acquire); }

  // For the reader's thread.

  /// An input of one record that is taken before all that is posted from now on. False: something waits already, and it
  /// would overtake that.
  bool put_first(const Input& record) {
    if (first_waits_ || !empty() || in_hand_ != 0) return false;
    record_.kind = record.kind; // one by one: a copy of it all would wait until it was written
    record_.more = false;
    record_.thing = record.thing;
    record_.handle = record.handle;
    record_.value = record.value;
    first_waits_ = true;
    return true;
  }

  /// What is in it now may be taken, until it is opened again. The tail first: who sees a record sees the overflow
  /// slots that its writer said before.
  void open() {
    limit_ = tail_.load(std::memory_order_acquire);
    if (spoken_.load(std::memory_order_relaxed) != 0) open_slots();
    closed_ = !first_waits_ && head_ == limit_ && in_hand_ == 0;
  }
  bool due() const { return first_waits_ || (!closed_ && (head_ != limit_ || in_hand_ != 0)); }
  /// False: nothing is due. True: mostly something is.
  bool is_open() const { return !closed_; }
  /// The next record, which stays where it is until another one is asked for; null: none is due and there.
  const Input* take() {
    if (!first_waits_) return take_posted();
    first_waits_ = false;
    closed_ = head_ == limit_ && in_hand_ == 0;
    return &record_;
  }
  /// Likewise, of the same input, where the last one says that there is more.
  DIRECTOR_PART const Input* take_more();

  /// Records claimed by writers and not taken yet, as seen by the reader.
  std::uint32_t waiting() const { return tail_.load(std::memory_order_acquire) - head_; }
  /// But for what was put first, and for overflow slots in hand: these stay there behind a record that is claimed and
  /// was not taken, or where a step ended before they were taken, and then the next one looks for them anyway.
  bool empty() const { return waiting() == 0 && spoken_.load(std::memory_order_relaxed) == 0; }
  /// Something is in it, wherever.
  bool waits() const { return !empty() || due(); }

private:
  /// Replaces the number by what `next` makes of it, in one step; what it was before.
  template <class Next>
  static std::uint32_t change(std::atomic<std::uint32_t>& number, Next next) {
    std::uint32_t now = number.load(std::memory_order_acquire);
    while (!number.compare_exchange_weak(now, next(now), std::memory_order_acq_rel, std::memory_order_acquire)) {}
    return now;
  }
  static std::uint32_t count(std::atomic<std::uint32_t>& number) {
    return change(number, [](std::uint32_t now) { return now + 1; });
  }

  // inbox.cpp
  bool claim(std::span<const Input> records);
  const Input* take_posted();
  bool take_cell();

  // overflow_slots.cpp
  bool waits_outside(Index slot) const;
  Index reserve(Index slot);
  void publish(Index slot, const OverflowSlot::Note& note);
  void count_lost();
  void open_slots();
  bool sweep();
  bool take_slot();
  void give(OverflowSlot& slot);
  void let_go(OverflowSlot& slot);

  // together.cpp
  DIRECTOR_PART void wait_for_leader(OverflowSlot& slot);
  DIRECTOR_PART OverflowSlot* first_of(std::uint32_t ticket);

  std::span<Cell> cells_;
  std::atomic<std::uint32_t> tail_{0};
  std::uint32_t head_ = 0;
  std::uint32_t limit_ = 0;  ///< the reader takes cells up to here
  bool closed_ = false;      ///< nothing is due, or the next record's writer is not ready yet
  bool first_waits_ = false; ///< in `record_`
  bool by_slot_ = false;     ///< what was taken last came by an overflow slot
  Input record_;             ///< what was put first, or was taken last
  std::span<OverflowSlot> slots_;
  std::atomic<std::uint32_t> tickets_{0};
  std::atomic<std::uint32_t> spoken_{
      0};                              ///< not 0: a record in a slot, or a loss, that the reader has not seen may wait
  std::atomic<std::uint32_t> lost_{0}; ///< inputs so far
  Index in_hand_ = 0;                  ///< slots with a place held that was not taken
  OverflowSlot* given_ = nullptr;      ///< the slot whose place was given out, until the next one is asked for
};

} // namespace director
