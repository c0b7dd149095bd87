#pragma once
// SPDX-License-Identifier: MIT
// What was decided before. A pass is a function of how the groups of a component stand and of what was asked for, came
// true or waits to run since: the situation. A robot is in few situations, again and again. So a component that is not
// large keeps its last decisions, numbered, and the moves between them: after decision 3, in this situation,
// decision 5. Situations are compared as a whole; what is not known is decided by a pass, as everything is without this
// memory, which is no part of the decision state. When a component's part is full, it begins anew; where that was of
// little use, it rests for a while.

#include "runtime/core/fetch.hpp"
#include "runtime/core/tables.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace director {

/// Bits of Recall::Move.
namespace moved {
inline constexpr std::uint8_t on_last = 1, on_stale = 2; ///< what the pass depends on
inline constexpr std::uint8_t other_decision = 4;
inline constexpr std::uint8_t begins = 8;    ///< some group does, as in Recall::Effect
inline constexpr std::uint8_t foreseen = 16; ///< its effects are written down
inline constexpr std::uint8_t too_long = 32; ///< there is no room for them
inline constexpr std::uint8_t rare = 64;     ///< some group stops, begins, leaves or is passed over
} // namespace moved

class Recall {
public:
  using Word = std::uint64_t;

  static constexpr std::size_t most_decisions = 16; ///< of one component
  static constexpr std::size_t most_moves = 48;     ///< of one component,
  static constexpr std::size_t places = 64;         ///< found in a table of so many rows
  static constexpr std::uint16_t rest = 4096;       ///< decisions
  static constexpr Index most_groups = 64;          ///< of a component; what is larger is always decided by passes
  static constexpr Index most_levels = 64;          ///< of an edge
  static constexpr std::uint8_t anew = 128;         ///< of an edge's byte: it is asked for anew
  static constexpr std::uint8_t unknown = 255;      ///< instead of a decision's number

  /// One row of what acting on a move comes to.
  struct Effect {
    static constexpr Index begins = 256; ///< with its reasons: it has a handler that is called, or a period
    static constexpr Index again = 512;  ///< all stand as before: request() told whom its outdated orders concern
    std::uint32_t where = 0; ///< where the value is written: bytes from the beginning of the state; or a group
    Index value = 0;         ///< with a group that gets a reason to run: bits of Reason, and of the above
  };
  /// What follows from a decision in a situation.
  struct Move {
    std::uint8_t to = unknown;
    std::uint8_t bits = 0;      ///< of `moved`
    std::uint8_t component = 0; ///< bits of `work` that are left of its component
    // Its effects, in this order:
    std::uint8_t words = 0;   ///< that change
    std::uint8_t stops = 0;   ///< in the old order
    std::uint8_t leaves = 0;  ///< not granted any more
    std::uint8_t gives = 0;   ///< get a reason to run, or are asked for anew; in the new order
    std::uint8_t passed = 0;  ///< are asked for anew and not granted
    std::uint8_t asked = 0;   ///< how many groups are asked for anew: no rows
    std::uint16_t next = 0;   ///< word: the move that was made behind it the last time; 0: none was
    std::uint16_t effect = 0; ///< word: the first row
  };
  /// Of siblings of one urgency it counts which was asked for first. Were they, in the order in which they are
  /// declared?
  enum class Ties : std::uint8_t { none, in_order, out_of_order, unknown };
  struct Head {
    std::uint8_t decisions = 0, moves = 0;
    Ties ties = Ties::none;    ///< `none`: no sibling can have the urgency of another
    std::uint8_t used = 0;     ///< how often a move was, since the part began anew; 255: or more often
    std::uint16_t rest = 0;    ///< for so many decisions nothing is looked up or learnt
    std::uint16_t taken = 0;   ///< word: the last move
    std::uint16_t guess = 0;   ///< word: the one that was made behind it the last time; 0: none was
    std::uint16_t end = 0;     ///< word: behind the moves and their effects
    std::uint16_t effects = 0; ///< rows of them in use,
    std::uint16_t room = 0;    ///< of so many
    std::uint16_t words = 0;   ///< of a situation
    std::uint16_t rows = 0;    ///< of a decision
  };

  static constexpr std::size_t move_words = 2, head_words = 3;
  static constexpr std::size_t place_words = places * sizeof(std::uint16_t) / sizeof(Word);

  /// One component's part: where its arrays begin.
  class Part {
  public:
    Part() = default; ///< it has none
    explicit Part(std::uint8_t* begin) : begin_(begin) {}
    explicit operator bool() const { return begin_ != nullptr; }

    Head& head() const { return *at<Head>(0); }
    /// The situation in hand: a byte for the decision that stands (or unknown), and for each edge, group and condition
    /// of the component.
    Word* question() const { return at<Word>(head_words); }
    std::uint8_t& current() const { return *at<std::uint8_t>(head_words); }
    std::uint8_t* bytes() const { return at<std::uint8_t>(head_words) + 1; }
    /// The decision from which a move leads.
    static std::uint8_t from(const Move& move) { return *situation<std::uint8_t>(move); }
    Word* digest() const { return at<Word>(digests_at()); } ///< of each decision
    const Index* row(std::size_t number) const { return decisions() + number * head().rows; }
    /// Here a decision is written that may be a new one; there is room while it is not full().
    Index* spare() const { return decisions() + head().decisions * head().rows; }
    const Effect* effects(const Move& move) const { return at<Effect>(move.effect); }
    /// Where a move's are written that has none yet; Head::end and Head::effects are the writer's.
    Effect* begin_effects(Move& move) const {
      move.effect = head().end;
      return at<Effect>(move.effect);
    }

    /// The move from the decision that stands, in the situation in hand; null: it is not known. Mostly the last move is
    /// followed by the one that followed it before.
    Move* find() const {
      Head& own = head();
      if (own.guess == 0 || !is_asked(*at<Move>(own.guess))) {
        const std::uint16_t word = places_of_moves()[look_up()];
        if (word == 0) return nullptr;
        at<Move>(own.taken)->next = own.guess = word;
      }
      return at<Move>(own.guess);
    }
    /// It is made, the one that was found.
    void take(const Move& move) const {
      Head& own = head();
      own.taken = own.guess;
      own.guess = move.next;
      current() = move.to;
    }
    /// The same, where it is not known: a new one, to the decision that is written down in `to`.
    Move& add(std::uint8_t to) const;
    /// The number of the spare decision; that of an equal one, if there is one.
    std::uint8_t number_spare() const;
    bool full() const;
    void forget() const;
    /// It begins anew, after a rest if less was recalled than learnt.
    void make_room() const;

  private:
    template <class T>
    T* at(std::size_t word) const {
      return reinterpret_cast<T*>(begin_ + word * sizeof(Word)); // reset() and learning write them
    }
    // Moves and their effects come first, in the order in which they were learnt: what is used together lies together.
    std::size_t first_move() const { return head_words + head().words; }
    std::size_t places_at() const { return first_move() + most_moves * (move_words + head().words) + head().room; }
    std::size_t digests_at() const { return places_at() + place_words; }
    Index* decisions() const { return at<Index>(digests_at() + most_decisions); }
    std::uint16_t* places_of_moves() const { return at<std::uint16_t>(places_at()); } ///< word; 0: it is free
    /// It lies behind its move.
    template <class T>
    static T* situation(Move& move) {
      return reinterpret_cast<T*>(reinterpret_cast<std::uint8_t*>(&move) + move_words * sizeof(Word));
    }
    template <class T>
    static const T* situation(const Move& move) {
      return reinterpret_cast<const T*>(reinterpret_cast<const std::uint8_t*>(&move) + move_words * sizeof(Word));
    }
    bool is_asked(const Move& move) const {
      const Word *const known = situation<Word>(move), *const wanted = question();
      const std::size_t words = head().words;
      for (std::size_t i = 0; i < words; ++i) {
        if (known[i] != wanted[i]) return false;
      }
      return true;
    }
    std::size_t look_up() const;

    std::uint8_t* begin_ = nullptr;
  };

  /// The memory that it needs, at most; 0 where an Index would not find each byte, and else the same for every size of
  /// Index.
  static constexpr std::size_t bytes(const Tables& t) {
    std::size_t parts = 0;
    for (const Component& row : t.components) parts += size_of(t, row).all();
    const std::size_t all = (lists(t) + parts) * sizeof(Word);
    return parts == 0 || all > nil ? 0 : all;
  }

  /// `memory`: bytes(t) of them, aligned to 8; with less, nothing is recalled.
  Recall(const Tables& t, std::span<std::byte> memory);
  Recall(const Recall&) = delete;
  Recall& operator=(const Recall&) = delete;

  /// Forgets everything: nothing is requested, pending or true.
  void reset(const Tables& t);

  /// Siblings that can have one urgency: then it counts which was asked for first.
  static bool can_tie(const Tables& t, const Edge& a, const Edge& b);

  bool on() const { return begin_ != nullptr; }
  Part part(Index component) const { return on() && begin_[component] != 0 ? part_at(begin_[component]) : Part{}; }

  // The bytes of the situations in hand.
  std::uint8_t& byte(std::uint32_t place) const { return bytes_[place]; }
  /// Where that of the first edge of a component is, behind which those of the others lie, and those of its groups; 0:
  /// nobody looks at them.
  Index edges_at(Index component) const {
    const Part own = part(component);
    return own ? static_cast<Index>(own.bytes() - bytes_) : Index{0};
  }
  /// Which edge of the component of that part it is.
  std::size_t place(Index byte, const Part& part) const {
    return static_cast<std::size_t>(bytes_ + byte - part.bytes());
  }
  /// Where the byte of a condition is, 0 as above; `several`: in several components. Only while it is on().
  std::uint32_t condition(Index c) const { return condition_place_[c]; }
  static constexpr std::uint32_t several = 1;

private:
  static constexpr Word mix(Word digest, Word word) {
    digest = (digest ^ word) * 0x9e3779b97f4a7c15U;
    return digest ^ digest >> 32;
  }

  /// A part begins where a line of the cache does, if the memory does.
  static constexpr std::size_t lines(std::size_t words) {
    constexpr std::size_t each = line_of_cache / sizeof(Word);
    return (words + each - 1) / each * each;
  }

  /// Of one component, in words but for `rows`, which are of Index, as if it had 32 bits.
  struct Size {
    std::size_t question = 0, rows = 0, effects = 0;
    constexpr std::size_t all() const {
      return question == 0 ? 0 : lines(fixed + question * (1 + most_moves) + most_decisions * rows / 2 + effects);
    }
  };
  static constexpr std::size_t fixed = head_words + move_words * most_moves + place_words + most_decisions;

  /// A word for edges and groups of what has no part; then where the parts begin, and the places of conditions.
  static constexpr std::size_t lists(const Tables& t) {
    return lines(1 + (t.components.size() + t.conditions.size() + 1) / 2);
  }
  /// Without a question: the component has no part.
  static constexpr Size size_of(const Tables& t, const Component& row) {
    Size size;
    if (row.groups.size() > most_groups || row.edges.empty()) return size;
    for (const Index e : t.list(row.edges)) {
      if (t.edges[e].levels.size() > most_levels) return size;
    }
    std::size_t slots = 0;
    for (const Index g : t.list(row.groups)) slots += t.groups[g].slots.size();
    const std::size_t rows = 8 * std::size_t{row.groups.size()} + 5 + 2 * std::size_t{row.edges.size()} + slots;
    if (rows > 0xfff0) return size;
    size.question = (1 + std::size_t{row.edges.size()} + row.groups.size() + row.conditions.size() + 7) / 8;
    size.rows = (rows + 3) / 4 * 4;
    const std::size_t things = std::size_t{row.groups.size()} + row.edges.size();
    size.effects = most_moves * (things < 8 ? 4 : things > 32 ? 16 : things / 2);
    const std::size_t found_by_word = size.question * (1 + most_moves) + size.effects + fixed;
    return found_by_word > 0xffff ? Size{} : size;
  }
  Part part_at(std::uint32_t word) const { return Part(bytes_ + std::size_t{word} * sizeof(Word)); }

  Word nowhere_ = 0; ///< instead of a memory
  std::uint8_t* bytes_ = reinterpret_cast<std::uint8_t*>(&nowhere_);
  std::uint32_t* begin_ = nullptr; ///< of each component's part: word; 0: it has none; null: there is no memory
  std::uint32_t* condition_place_ = nullptr; ///< of its byte; 0: nobody looks at it; `several`
};

} // namespace director
