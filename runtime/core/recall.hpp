#pragma once
// What was decided before. A pass is a function of how the groups of a component stand and of what was asked for, came
// true or waits to run since: the situation. A robot is in few situations, again and again. So a component that is not
// large keeps its last decisions, numbered, and the moves between them: after decision 3, in this situation,
// decision 5. Situations are compared as a whole; what is not known is decided by a pass, as everything is without this
// memory, which is no part of the decision state. When a component's part is full, it begins anew; where that was of
// little use, it rests for a while.

#include "runtime/core/tables.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace director {

/// Bits of Recall::Move.
namespace moved {
inline constexpr std::uint8_t on_last = 1, on_stale = 2; ///< what the pass depends on
inline constexpr std::uint8_t other_decision = 4, stops = 8;
inline constexpr std::uint8_t other_order = 16, other_plans = 32;
inline constexpr std::uint8_t begins = 64; ///< some group does, as in Acts
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

  /// What differs between two decisions.
  struct Difference {
    Word groups = 0; ///< a bit for each, as in Component::groups
    Word edges = 0;  ///< likewise; from the 65th on they share bits
    Word counts = 0; ///< a bit for each group: whether it counted that its orders are outdated
  };
  /// What acting on the difference comes to, where it is short: whom it stops, in the old order, and behind these whom
  /// it gives a reason to run, in the new order.
  struct Acts {
    static constexpr std::size_t most = 7;
    static constexpr std::uint8_t begins = 128; ///< with its reasons: it has a handler that is called, or a period
    std::uint8_t stops = 0;
    std::uint8_t gives = unknown;    ///< unknown: look at the difference
    std::uint8_t group[most] = {};   ///< its place in Component::groups
    std::uint8_t reasons[most] = {}; ///< bits of Reason
  };
  /// What follows from a decision in a situation.
  struct Move {
    std::uint8_t from = unknown; ///< unknown: there is none yet
    std::uint8_t to = unknown;
    std::uint8_t bits = 0; ///< of `moved`
    bool compared = false; ///< the difference is known
    std::uint8_t next = unknown; ///< the move that was made behind it the last time
    Acts acts;
    Difference difference;
  };
  struct Head {
    std::uint8_t current = unknown; ///< the decision that stands
    std::uint8_t decisions = 0, moves = 0;
    bool ties = false;      ///< which of two siblings was asked for first can matter
    std::uint8_t used = 0;  ///< how often a move was, since the part began anew; 255: or more often
    std::uint8_t taken = 0; ///< the last move
    std::uint16_t rest = 0; ///< for so many decisions nothing is looked up or learnt
  };

  static constexpr std::size_t move_words = sizeof(Move) / sizeof(Word);
  /// There are no more edges than bytes in a situation.
  static constexpr std::size_t ties_of(std::size_t words) { return (words + 7) / 8; }

  /// One component's part: where its arrays begin.
  class Part {
  public:
    Part() = default; ///< it has none
    Part(std::uint8_t* begin, std::size_t words, std::size_t rows) : begin_(begin), words_(words), rows_(rows) {}
    explicit operator bool() const { return begin_ != nullptr; }

    Head& head() const { return *at<Head>(0); }
    std::size_t words() const { return words_; } ///< of a situation
    std::size_t rows() const { return rows_; }   ///< of a decision
    /// The situation in hand: a byte for each edge, group and condition of the component.
    Word* question() const { return at<Word>(1); }
    std::uint8_t* bytes() const { return at<std::uint8_t>(1); }
    Move& move(std::size_t number) const { return *at<Move>(move_at(number)); }
    Word* asked(std::size_t number) const { return at<Word>(move_at(number) + move_words); } ///< the move's situation
    /// A bit for each edge, as in Component::edges: a sibling can tie with it.
    Word* ties() const { return at<Word>(ties_at()); }
    Word* digest() const { return at<Word>(ties_at() + ties_of(words_)); } ///< of each decision
    const Index* row(std::size_t number) const { return decisions() + number * rows_; }
    /// Here a decision is written that may be a new one; there is room while it is not full().
    Index* spare() const { return decisions() + head().decisions * rows_; }

    /// The move from the decision that stands, in the situation in hand; null: it is not known. Mostly the last move is
    /// followed by the one that followed it before.
    Move* find() const {
      Head& own = head();
      Move& last = move(own.taken);
      if (last.next == unknown || !is_asked(last.next, own.current)) {
        const std::uint8_t number = places_of_moves()[look_up()];
        if (number == unknown) return nullptr;
        last.next = number;
      }
      own.taken = last.next;
      return &move(own.taken);
    }
    /// The same, where it is not known: a new one, to the decision that is written down in `to`.
    Move& add(std::uint8_t from, std::uint8_t to) const;
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
    std::size_t move_at(std::size_t number) const { return 1 + words_ + number * (move_words + words_); }
    std::size_t ties_at() const { return move_at(most_moves) + places / sizeof(Word); }
    Index* decisions() const { return at<Index>(ties_at() + ties_of(words_) + most_decisions); }
    std::uint8_t* places_of_moves() const { return at<std::uint8_t>(move_at(most_moves)); }
    bool is_asked(std::size_t number, std::uint8_t from) const {
      if (move(number).from != from) return false;
      const Word *const situation = asked(number), *const wanted = question();
      for (std::size_t i = 0; i < words_; ++i) {
        if (situation[i] != wanted[i]) return false;
      }
      return true;
    }
    std::size_t look_up() const;

    std::uint8_t* begin_ = nullptr;
    std::size_t words_ = 0, rows_ = 0;
  };

  /// The memory that it needs, at most; the same for every size of Index.
  static constexpr std::size_t bytes(const Tables& t) {
    std::size_t parts = 0;
    for (const Component& row : t.components) parts += size_of(t, row).all();
    return parts == 0 ? 0 : (lists(t) + parts) * sizeof(Word);
  }

  /// `memory`: bytes(t) of them, aligned to 8; with less, nothing is recalled.
  Recall(const Tables& t, std::span<std::byte> memory);

  /// Forgets everything: nothing is requested, pending or true.
  void reset(const Tables& t);

  bool on() const { return entries_ != nullptr; }
  Part part(Index component) const {
    return on() && entries_[component].begin != 0 ? part_at(entries_[component]) : Part{};
  }

  /// The byte of an edge in the situation in hand. Only while it is on().
  std::uint8_t& edge(Index e) const { return bytes_[edge_place_[e]]; }

private:
  static constexpr Word mix(Word digest, Word word) {
    digest = (digest ^ word) * 0x9e3779b97f4a7c15U;
    return digest ^ digest >> 32;
  }

  /// Of one component, in words but for `rows`.
  struct Size {
    std::size_t question = 0, ties = 0, rows = 0;
    constexpr std::size_t all() const {
      return question == 0 ? 0 : fixed + ties + question * (1 + most_moves) + most_decisions * rows / 2;
    }
  };
  static constexpr std::size_t fixed = 1 + move_words * most_moves + places / sizeof(Word) + most_decisions;
  struct Entry {
    std::uint32_t begin = 0; ///< word; 0: the component has no part
    std::uint16_t question = 0, rows = 0;
  };

  /// Entries, and the places of edges; the word behind them is for edges of what has no part.
  static constexpr std::size_t lists(const Tables& t) { return t.components.size() + (t.edges.size() + 1) / 2 + 1; }
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
    size.question = (std::size_t{row.edges.size()} + row.groups.size() + row.conditions.size() + 7) / 8;
    size.ties = ties_of(size.question);
    size.rows = (rows + 3) / 4 * 4;
    return size;
  }
  Part part_at(const Entry& entry) const {
    return {bytes_ + std::size_t{entry.begin} * sizeof(Word), entry.question, entry.rows};
  }
  static void find_ties(const Tables& t, const Component& row, const Part& part);

  std::uint8_t* bytes_ = nullptr;
  Entry* entries_ = nullptr; ///< one for each component; null: there is no memory
  std::uint32_t* edge_place_ = nullptr;
};

} // namespace director
