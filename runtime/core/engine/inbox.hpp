#pragma once
// SPDX-License-Identifier: MIT
// The inbox: a bounded queue of inputs with many writers and one reader, without locks and without memory of its own.
// An input may have several records (several states, several root tasks): it is posted whole or not at all. Requests
// and cancels of root tasks, and inputs that set one state, are never refused: if the queue is full, they use an
// overflow slot, and are taken after all that was in the queue then. Inputs that are refused, or replaced in a slot
// before they were taken, are counted. Needs 32-bit compare-and-swap and nothing more; on a core without it the program
// supplies what the compiler calls for it (GCC: __atomic_compare_exchange_4), as a critical section. Source: D.
// Vyukov's bounded queue, with several cells claimed at once.

#include "runtime/core/base/parts.hpp"

#include <atomic>

namespace director {

/// The most requests of one root task with data in the inbox. One more uses an overflow slot.
inline constexpr Index waiting_requests = 4;

/// One record of an input; an input has one or more.
struct Input {
  enum class Kind : std::uint8_t { request, cancel, set, fire, enable, disable };
  Kind kind = Kind::set;
  bool more = false;      ///< the next record belongs to the same input (request and set): see link()
  Index thing = 0;        ///< root edge, state, trigger or provider; nil: cancel of all root edges
  Index handle = nil;     ///< request: place of its data, from waiting_requests on in an overflow slot; nil: no data
  std::int32_t value = 0; ///< set: the value; request: the level, of Tables::levels
  Index level() const { return static_cast<Index>(value); }
  void set_level(Index level) { value = static_cast<std::int32_t>(level); }
};

/// Makes several records one input.
void link(std::span<Input> records);

/// The overflow slot of one root task or external state, for when the queue is full: the last record counts. A place is
/// free, then being filled by one writer, then published (at most one in a slot, the newest), then held by the reader,
/// then free again. Each step is a compare-and-swap of `states`; to publish a record frees the one before it.
struct OverflowSlot {
  /// The newest record, one held by the reader, and two being written.
  static constexpr Index places = 4;
  enum class PlaceState : std::uint32_t { free = 0, filling = 1, published = 2, held = 3 };
  struct Note {
    Input input;                ///< `more`: the input has several records
    std::uint32_t position = 0; ///< position in the queue: the records before it are taken first
    std::uint32_t ticket = 0;   ///< later inputs have higher ones; records of one input have the same one
    Index leader = 0;           ///< the slot of the record of the input that is published last
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
  const Note& held_note() const { return notes[held]; }

  std::atomic<std::uint32_t> states{0}; ///< two bits for each place
  std::array<Note, places> notes;
  Index held = nil; ///< used by the reader: the place that it holds
};

class Inbox {
public:
  struct Cell {
    std::atomic<std::uint32_t> sequence{0};
    Input input;
  };

  /// `cells`: a power of two of them, at least 2. `slots`: one for each root edge, then one for each other slot of
  /// put(); without them a full inbox refuses everything. Both are owned by the caller, who must keep them.
  explicit Inbox(std::span<Cell> cells, std::span<OverflowSlot> slots = {});
  Inbox(const Inbox&) = delete;
  Inbox& operator=(const Inbox&) = delete;

  // For writers: any thread.

  /// Posts the records of one input, `more` set on all but the last. False: it is full, and the input is lost.
  bool post(std::span<const Input> records);
  /// Posts an input of one record, without data, that has an overflow slot: it is not refused.
  bool put(const Input& record, Index slot);

  // Requests of several root tasks, or with data, are not refused either. The slot of a request is its edge.
  /// Posts the records. False: the inbox is full, or an earlier input about one of these tasks waits in a slot.
  bool post_in_turn(std::span<const Input> records);
  /// Reserves a place of an overflow slot for each record, as its handle, where its data go before they are published.
  /// Nil: this record does not count, because a later one is about the same root task.
  void reserve(std::span<Input> records);
  void publish(std::span<const Input> records);

  /// Inputs that were refused or replaced so far; from any thread.
  std::uint32_t lost() const { return lost_.load(std::memory_order_acquire); }

  // For the reader's thread.

  /// Adds an input of one record, to be taken before all that is posted later. False: another waits already.
  bool put_first(const Input& record) {
    if (first_waits_ || !empty() || held_count_ != 0) return false;
    record_.kind = record.kind; // one by one: a copy of the whole would wait until it was written
    record_.more = false;
    record_.thing = record.thing;
    record_.handle = record.handle;
    record_.value = record.value;
    first_waits_ = true;
    return true;
  }

  /// Makes what is in the inbox now available until it is opened again. The tail is read first: a reader that sees a
  /// record sees the overflow slots that its writer published before.
  void open() {
    limit_ = tail_.load(std::memory_order_acquire);
    if (unseen_.load(std::memory_order_relaxed) != 0) open_slots();
    closed_ = !first_waits_ && head_ == limit_ && held_count_ == 0;
  }
  bool due() const { return first_waits_ || (!closed_ && (head_ != limit_ || held_count_ != 0)); }
  /// False: nothing is due. True: probably something is.
  bool is_open() const { return !closed_; }
  /// The next record, valid until another one is taken; null: none is due and complete.
  const Input* take() {
    if (!first_waits_) return take_posted();
    first_waits_ = false;
    closed_ = head_ == limit_ && held_count_ == 0;
    return &record_;
  }
  /// The next record of the same input, if the last one has `more`.
  DIRECTOR_PART const Input* take_more();

  /// Records claimed by writers and not taken yet, as the reader sees it.
  std::uint32_t waiting() const { return tail_.load(std::memory_order_acquire) - head_; }
  /// Ignores the record put first, and overflow slots held by the reader: these remain behind a claimed record that was
  /// not taken, or if a step ended before they were taken, and then the next step looks for them anyway.
  bool empty() const { return waiting() == 0 && unseen_.load(std::memory_order_relaxed) == 0; }

private:
  /// Replaces the number by next(number) atomically; returns the old one.
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
  bool is_pending(Index slot) const;
  Index reserve(Index slot);
  void publish(Index slot, const OverflowSlot::Note& note);
  void count_lost();
  void count_replaced(std::uint32_t ticket);
  void open_slots();
  bool sweep();
  bool take_slot();
  void deliver(OverflowSlot& slot);
  void release();
  Index move(OverflowSlot& slot, OverflowSlot::PlaceState from, OverflowSlot::PlaceState to);
  void free(OverflowSlot& slot, Index place);
  void lose(OverflowSlot& slot, Index place);

  // together.cpp
  DIRECTOR_PART void wait_for_leader(OverflowSlot& slot);
  DIRECTOR_PART OverflowSlot* first_of(std::uint32_t ticket);

  std::span<Cell> cells_;
  std::atomic<std::uint32_t> tail_{0};
  std::uint32_t head_ = 0;
  std::uint32_t limit_ = 0;  ///< the reader takes cells up to this position
  bool closed_ = false;      ///< nothing is due, or the next record is not complete
  bool first_waits_ = false; ///< there is a record that was put first, in `record_`
  Index held_count_ = 0;     ///< slots with a held place that was not taken
  Input record_;             ///< the record that was put first, or taken last
  std::span<OverflowSlot> slots_;
  std::atomic<std::uint32_t> tickets_{0};
  std::atomic<std::uint32_t> unseen_{
      0}; ///< not 0: there may be a record in a slot, or a loss, that the reader has not seen
  std::atomic<std::uint32_t> lost_{0};       ///< inputs lost so far
  std::atomic<std::uint32_t> replaced_{~0U}; ///< ticket of the input that was counted last because it was replaced
  OverflowSlot* taken_ = nullptr;            ///< the slot whose record was taken last; null: a cell
};

} // namespace director
