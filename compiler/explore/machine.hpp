#pragma once
// The real engine, one micro-step at a time, with bodies that pick from a tape what they do. Its state can be taken
// out, put back and told apart from others.

#include "compiler/explore/ground.hpp"
#include "compiler/explore/tape.hpp"
#include "runtime/core/engine.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace director::compiler {

/// What may happen next.
struct Happens {
  enum class Kind : std::uint8_t {
    go,      ///< the engine goes on: a run, what handlers set, or one more arbitration
    request, ///< `row` of Ground::requests
    cancel,  ///< root edge `row`
    set,     ///< `row` of Ground::sets
    fire,    ///< trigger `row`
    wake,    ///< a wait or `every` of group `row` is due
    expire,  ///< `row` of Ground::expiries
    breaks,  ///< `row` of Ground::broken
  };
  Kind kind = Kind::go;
  Index row = 0;
};

/// What a body or handler did.
struct Deed {
  enum class Kind : std::uint8_t { run, start, stop };
  enum class Answer : std::uint8_t { pack, kept, keep, done };
  Kind kind = Kind::run;
  Answer answer = Answer::pack;
  Index group = 0, provider = nil;
  std::size_t pack = 0; ///< of FreeBody::packs
  std::size_t puts = 0; ///< of FreeBody::puts, Ground::starting or Ground::stopping
};

/// Between two micro-steps.
enum class Phase : std::uint8_t {
  rest,   ///< nothing is left to do without an input
  open,   ///< an input was taken and nothing has run yet: more inputs may stand in the inbox
  closed, ///< runs go on to the end before the next input
};

/// A state of the engine, packed.
struct Packed {
  std::vector<std::uint64_t> words;
  Phase phase = Phase::rest;
  std::uint64_t watch = 0; ///< what somebody remembers beside it (assertions)
};

/// How much of what may happen is tried.
enum class Breadth : std::uint8_t {
  all,
  lean, ///< one input at a time, and each only at rest; nothing is kept. Fewer states, so that more of them can be seen
};

/// A state as numbers: its values, and all the rest.
struct Print {
  std::uint64_t rest = 0, values = 0;
};

/// What can be told of a micro-step before it is taken: it is a body's that gives one of so many answers and sets one
/// of these, or the outside's that sets the only one of these. No answers: nothing can be told.
struct Choices {
  bool body = false;
  std::size_t answers = 0;
  std::span<const Puts> puts;
};

class Machine {
public:
  Machine(const Ground& ground, Breadth breadth);
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  void start(); ///< the first state, at rest
  void pack(Packed& out) const;
  void unpack(const Packed& packed); ///< and `again()` comes back to it
  void again();

  /// What may happen now, in a fixed order.
  void list(std::vector<Happens>& out) const;
  /// One micro-step; its bodies pick from the tape. What they did is in deeds().
  void take(const Happens& happens, Tape& tape);
  const std::vector<Deed>& deeds() const { return deeds_; }

  /// The same for states that behave alike (and with a chance of 2^-64 for two that do not). Semantics: see key.cpp.
  Print print() const;
  /// One number of it, and of what somebody remembers beside the state.
  static std::uint64_t key(const Print& print, std::uint64_t watch);
  /// Forgets what no decision depends on: how long ago requests were made.
  void forget();

  /// About the state that was unpacked: of what the engine does by itself, before anything else was taken.
  Choices choices(const Happens& happens) const;
  /// The same for micro-steps that end alike, in as many ways (with the same chance), wherever they begin: those that
  /// only differ in values that they overwrite. `from`: the print of
  /// the state that was unpacked.
  /// `each`: which of the puts it is counts, not only what they make of the values.
  std::uint64_t foresee(const Print& from, std::uint64_t watch, const Choices& choices, std::size_t answer,
                        std::size_t puts, bool each) const;

  Phase phase() const { return phase_; }
  const Engine& engine() const { return engine_; }
  const Ground& ground() const { return ground_; }

private:
  Outcome run(Run& run);
  void handle(Handling& handling, Deed::Kind kind);
  /// What a body may answer now: a pack, a pack whose requests are kept, that all stays, that it is done.
  struct Answers {
    std::size_t packs = 0, kept = 0, others = 0;
    std::size_t count() const { return packs + kept + others; }
  };
  Answers answers(Index group, Index provider) const;
  bool keeps(const Asks& asks) const;
  bool runs_next() const;
  void post(const Happens& happens);
  void find_marks();
  std::uint64_t mark_of(Index state, std::int32_t value) const {
    return marks_[first_mark_[state] + ground_.classes[state].of(value)];
  }
  void read(std::vector<std::uint64_t>& out) const;
  void write(const std::vector<std::uint64_t>& from);
  Bodies table();

  const Ground& ground_;
  Breadth breadth_;
  std::vector<Outcome (*)(void*, Run&)> runs_;
  std::vector<void (*)(void*, Handling&)> starts_, stops_;
  std::vector<Inbox::Cell> cells_;
  Inbox inbox_;
  std::vector<std::uint64_t> memory_;
  Engine engine_;
  std::size_t block_; ///< bytes of the decision state
  mutable std::vector<std::uint64_t> now_, differs_;
  std::vector<std::uint64_t> first_, loaded_;
  Phase phase_ = Phase::rest, loaded_phase_ = Phase::rest;
  Tape* tape_ = nullptr;
  std::vector<Deed> deeds_;
  std::vector<Input> records_;
  std::vector<std::int32_t> loaded_values_;
  std::vector<Index> scratch_;
  // key.cpp
  std::vector<Index> minded_;           ///< states whose values count
  std::vector<std::size_t> first_mark_; ///< state: of its classes, in marks_; all of those that do not count share one
  std::vector<std::uint64_t> marks_;    ///< class of a state: its number in a Print
  std::vector<Range> contested_;        ///< edges of one requester that can be requested with the same priority
  mutable std::vector<std::uint64_t> projection_;
};

} // namespace director::compiler
