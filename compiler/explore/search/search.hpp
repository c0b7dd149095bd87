#pragma once
// SPDX-License-Identifier: MIT
// Breadth-first search through all states, on all cores. Result and order depend only on the behaviour and the bound.

#include "compiler/explore/search/blocked.hpp"
#include "compiler/explore/search/watch.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace director::compiler {

struct SearchProgress {
  std::size_t states = 0, waiting = 0; ///< found, and of these unexplored
  std::size_t bytes = 0;               ///< that they take
};

struct SearchOptions {
  std::size_t bound = 1'000'000;       ///< distinct states
  unsigned threads = 0;                ///< 0: as many as there are cores
  std::vector<std::size_t> assertions; ///< of the Model: to check
  Breadth breadth = Breadth::all;
  bool only_assertions = false; ///< ends as soon as all of them are decided
  bool foresees = true; ///< skips micro-steps that are known to have the same result as an earlier one. Changes nothing
  std::function<void(const SearchProgress& so_far)> progress; ///< called now and then
  std::function<void(const Machine& machine)> leave; ///< called before the micro-steps from one state, on the same core
  std::function<void(const Machine& machine)> look;  ///< called after each micro-step, on its core
};

/// A way from the start: for each state the index among all possibilities in it.
using Way = std::vector<std::uint32_t>;

struct RootSet {
  std::vector<Index> roots; ///< edges: those that are requested
  std::size_t found = 0, explored = 0;
  bool operator==(const RootSet&) const = default;
};

struct Searched {
  std::size_t states = 0, explored = 0, micro_steps = 0;
  Breadth breadth = Breadth::all;       ///< with which its ways can be followed
  bool complete = false;                ///< with this breadth
  std::vector<std::optional<Way>> seen; ///< assertion: the shortest way to what Watch searches
  Happened happened;
  std::vector<bool> doubted; ///< assertion: undecidable in some state; empty: none is
  /// A cycle of micro-steps without an input, with the usual answer of every body: the way to its beginning, and its
  /// length. At most a few.
  struct Cycle {
    Way way;
    std::size_t length = 0;
    bool operator==(const Cycle&) const = default;
  };
  std::vector<Cycle> cycles;
  std::vector<RootSet> root_sets;
  std::size_t most_bytes = 0; ///< that states took at most at one time

  explicit Searched(const Tables& tables) : happened(tables) {}
};

/// Whether all that may happen was tried: what was not seen then does not happen.
inline bool tried_all(const Ground& ground, const Searched& searched) {
  return searched.complete && ground.narrowed.empty();
}

/// More than `most_soft` assertions of the kind `soft` are searched for in groups, from the start for each group: the
/// numbers and what happened are those of the first search, and it is complete if all of them are, or have seen theirs.
Searched search(const Ground& ground, const SearchOptions& options);

/// One micro-step of a way, replayed.
struct Taken {
  Happens happens;
  std::vector<Action> actions;
  Phase before = Phase::rest, after = Phase::rest;
};
/// The ways of one search, each from the start without saving and restoring states in between. What can happen at a
/// state, and in how many ways each, is counted once for all ways that pass it: a place among all possibilities tells
/// no more than how many there are before it.
class Follower {
public:
  Follower(const Ground& ground, Breadth breadth) : ground_(ground), breadth_(breadth) {}

  std::vector<Taken> follow(const Way& way);
  /// Whether the last micro-step of a way shows what Watch searches.
  bool shows(const Way& way, std::size_t assertion);
  /// What blocks a task there: of a `beats` that is refuted.
  std::optional<Blocked> blocked(const Way& way, std::size_t assertion);
  /// What is taken there: of a `soft` that is refuted.
  std::optional<Cut> cut(const Way& way, std::size_t assertion);
  /// Micro-steps so far.
  std::size_t micro_steps() const { return micro_steps_; }

private:
  template <class Before, class After>
  void replay(const Way& way, Before&& before, After&& after);
  template <class After>
  void watch(const Way& way, std::size_t assertion, After&& after);

  const Ground& ground_;
  Breadth breadth_;
  std::map<Way, std::vector<std::uint32_t>> counts_; ///< after a way: of the first things that may happen
  std::size_t micro_steps_ = 0;
};

} // namespace director::compiler
