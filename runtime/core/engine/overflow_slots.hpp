#pragma once
// SPDX-License-Identifier: MIT
// Where requests and cancels of root tasks, and values of external states, go that find no room in the inbox, so that
// these are never refused: one slot for each root task, and one for each such state, in which the last one counts. Many
// writers, one reader, without locks. A place of a slot is free, then being filled by one writer, then published (at
// most one in a slot, the newest record), then in the reader's hands, then free again. Each step is a compare-and-swap
// of the slot's one word of states; to publish frees the record before it in the same step. What a slot held before,
// and the reader did not take, is counted as lost.

#include "runtime/core/base/parts.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <span>

namespace director {

/// How many requests of one root task with data can wait in the inbox at once. One more goes by OverflowSlots.
inline constexpr Index waiting_requests = 4;

/// One record of what the outside says to a behaviour; an input takes one or more of them.
struct Input {
  enum class Kind : std::uint8_t { request, cancel, set, fire, enable, disable };
  Kind kind = Kind::set;
  bool more = false;  ///< the next record belongs to the same input (request and set): see link()
  Index thing = 0;    ///< root edge, state, trigger or provider; nil: cancel of all root edges
  Index handle = nil; ///< request: where its data wait: up to waiting_requests in the inbox, from there on in a place
                      ///< of OverflowSlots; nil: it has none
  std::int32_t value = 0; ///< set: the value; request: the level, of Tables::levels
  Index level() const { return static_cast<Index>(value); }
  void set_level(Index level) { value = static_cast<std::int32_t>(level); }
};

/// Several records become one input.
void link(std::span<Input> records);

class OverflowSlots {
public:
  /// Of one slot: the newest record, one that the reader has in hand, and two that are being written.
  static constexpr Index places = 4;

  struct Note {
    Input input;                ///< `more`: its input has several records
    std::uint32_t position = 0; ///< in the inbox: what was there before is taken before
    std::uint32_t ticket = 0;   ///< later inputs have higher ones; records of one input have the same
    Index leader = 0;           ///< the slot of that record of the input which is published last
  };
  struct Slot {
    std::atomic<std::uint32_t> states{0}; ///< two bits a place
    std::array<Note, places> notes;
    Index held = nil; ///< the reader's: the place that it has in hand
  };

  /// The first ones are those of the root edges; owned by the caller, who must keep them.
  explicit OverflowSlots(std::span<Slot> slots) : slots_(slots) {}
  OverflowSlots(const OverflowSlots&) = delete;
  OverflowSlots& operator=(const OverflowSlots&) = delete;

  // For writers: any thread.

  bool has(Index slot) const { return slot < slots_.size(); }
  /// The newest record in this slot was not seen by the reader yet.
  bool wait(Index slot) const;
  /// A handle for a record in this slot and its data, which only the caller has until it publishes. Nil: so many others
  /// are writing right now that no place is left; theirs count as the later ones, and there is nothing to do.
  Index reserve(Index slot);
  /// The records of one input about root tasks, whose edges are their slots; each with the handle that was reserved for
  /// it, or nil.
  void publish(std::span<const Input> records, std::uint32_t position);
  /// An input of one record, with its handle, about anything that has a slot.
  void publish(Index slot, const Input& record, std::uint32_t position);
  /// One more input was lost; from here on the reader has something to see.
  void count_lost();

  std::uint32_t lost() const { return lost_.load(std::memory_order_acquire); } ///< for anybody

  // For the reader.

  /// Takes the newest record of every slot in hand; what is published later waits for the next time.
  void open();
  /// Of those in hand with a position up to this one, the one that was published first. `more`: there is another of the
  /// same input.
  bool take(std::uint32_t position, Input& out);
  /// The next record of the input that was taken last.
  DIRECTOR_PART bool take_more(Input& out);
  bool any_in_hand() const { return in_hand_ != 0; }
  /// None waits that the reader has not in hand.
  bool none_spoken() const { return spoken_.load(std::memory_order_relaxed) == 0; }

private:
  enum class PlaceState : std::uint32_t { free = 0, filling = 1, published = 2, held = 3 };

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

  void put(Index slot, const Note& note);
  bool sweep();
  DIRECTOR_PART void wait_for_leader(Slot& slot);
  void let_go(Slot& slot);
  Input give(Slot& slot);
  DIRECTOR_PART Slot* first_of(std::uint32_t ticket);

  std::span<Slot> slots_;
  std::atomic<std::uint32_t> tickets_{0};
  std::atomic<std::uint32_t> spoken_{0}; ///< not 0: a record, or a loss, that the reader has not seen may wait
  std::atomic<std::uint32_t> lost_{0};   ///< inputs so far
  Index in_hand_ = 0;                    ///< slots with a place held that was not taken
  std::uint32_t taken_ = 0;              ///< ticket of the input that was taken last
  Slot* given_ = nullptr;                ///< the slot whose place was given out, until the next one is asked for
};

} // namespace director
