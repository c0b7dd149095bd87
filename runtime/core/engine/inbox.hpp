#pragma once
// SPDX-License-Identifier: MIT
// The way in: a bounded queue of inputs with many writers and one reader, without locks and without memory of its own.
// An input may take several records (several states set at once, several root tasks): it goes in whole or not at all.
// What requests or cancels root tasks, or sets one state, is never refused: where the queue is full it goes by
// OverflowSlots, and is taken after all that was in the queue then. What is refused, or replaced there before it was
// taken, is counted. Needs 32-bit compare-and-swap and nothing more; on a core without it the program supplies what the
// compiler calls for it (GCC: __atomic_compare_exchange_4), as a critical section. Source: D. Vyukov's bounded queue,
// with several cells claimed at once.

#include "runtime/core/engine/overflow_slots.hpp"

#include <atomic>
#include <cstdint>
#include <span>

namespace director {

class Inbox {
public:
  struct Cell {
    std::atomic<std::uint32_t> sequence{0};
    Input input;
  };

  /// `cells`: a power of two of them, at least 2. `words`: a slot for each root edge, then one for each other that
  /// `put` names; without them a full inbox refuses everything. Both are owned by the caller, who must keep them.
  explicit Inbox(std::span<Cell> cells, std::span<OverflowSlots::Slot> words = {});
  Inbox(const Inbox&) = delete;
  Inbox& operator=(const Inbox&) = delete;

  // For writers: any thread.

  /// The records of one input, `more` set on all but the last. False: full, nothing went in, and the input is lost.
  bool post(std::span<const Input> records);
  /// An input of one record, without data, that has a slot of OverflowSlots: it is not refused.
  bool put(const Input& record, Index slot);

  // Requests of root tasks that are several or have data are not refused either.
  /// False: it is full, or a request or cancel of one of these tasks waits outside, and this one must wait behind it.
  bool post_in_turn(std::span<const Input> records);
  /// Reserves a place of OverflowSlots for each record, as its handle: there its data go before they are published.
  /// Nil: this record does not count, as a later one about the same root task does.
  void reserve(std::span<Input> records);
  void publish(std::span<const Input> records);

  std::uint32_t lost() const { return words_.lost(); } ///< inputs refused or replaced so far; from any thread

  // For the reader's thread.

  /// An input of one record that is taken before all that is posted from now on. False: something waits already, and it
  /// would overtake that.
  bool put_first(const Input& record) {
    if (first_waits_ || !empty() || words_.any_in_hand()) return false;
    record_.kind = record.kind; // one by one: a copy of it all would wait until it was written
    record_.more = false;
    record_.thing = record.thing;
    record_.handle = record.handle;
    record_.value = record.value;
    first_waits_ = true;
    return true;
  }

  /// What is in it now may be taken, until it is opened again.
  void open();
  bool due() const { return first_waits_ || (!closed_ && (head_ != limit_ || words_.any_in_hand())); }
  /// False: nothing is due. True: mostly something is.
  bool is_open() const { return !closed_; }
  /// The next record, which stays where it is until another one is asked for; null: none is due and there.
  const Input* take() {
    if (!first_waits_) return take_posted();
    first_waits_ = false;
    closed_ = head_ == limit_ && !words_.any_in_hand();
    return &record_;
  }
  /// Likewise, of the same input, where the last one says that there is more.
  DIRECTOR_PART const Input* take_more();

  /// Records claimed by writers and not taken yet, as seen by the reader.
  std::uint32_t waiting() const { return tail_.load(std::memory_order_acquire) - head_; }
  /// But for what was put first, and for overflow slots in hand: these stay there behind a record that is claimed and
  /// was not taken, or where a step ended before they were taken, and then the next one looks for them anyway.
  bool empty() const { return waiting() == 0 && words_.none_spoken(); }
  /// Something is in it, wherever.
  bool waits() const { return !empty() || due(); }

private:
  bool claim(std::span<const Input> records);
  const Input* take_posted();
  bool take_cell();

  std::span<Cell> cells_;
  std::atomic<std::uint32_t> tail_{0};
  std::uint32_t head_ = 0;
  std::uint32_t limit_ = 0;  ///< the reader takes cells up to here
  bool closed_ = false;      ///< nothing is due, or the next record's writer is not ready yet
  bool first_waits_ = false; ///< in `record_`
  Input record_;             ///< what was put first, or was taken last
  bool word_ = false;        ///< it came by an overflow slot
  OverflowSlots words_;
};

/// The tail first: who sees a record sees the overflow slots that its writer said before.
inline void Inbox::open() {
  limit_ = tail_.load(std::memory_order_acquire);
  if (!words_.none_spoken()) words_.open();
  closed_ = !first_waits_ && head_ == limit_ && !words_.any_in_hand();
}

} // namespace director
