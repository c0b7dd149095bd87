#pragma once
// SPDX-License-Identifier: MIT
// Breadth first through all states, on all cores. Result and order depend on nothing but the behaviour and the bound.

#include "compiler/explore/watch.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace director::compiler {

struct SearchProgress {
  std::size_t states = 0, waiting = 0; ///< found, and of these to be explored
  std::size_t bytes = 0;               ///< that they take
};

struct SearchOptions {
  std::size_t bound = 1'000'000;       ///< distinct states
  unsigned threads = 0;                ///< 0: as many as there are cores
  std::vector<std::size_t> assertions; ///< of the Model: to look at
  Breadth breadth = Breadth::all;
  bool only_assertions = false; ///< ends as soon as there is nothing left to see of them
  bool foresees = true; ///< takes no micro-step of which it knows that it ends as one that was taken. Changes nothing
  std::function<void(const SearchProgress& so_far)> progress; ///< now and then
  std::function<void(const Machine& machine)> leave; ///< before those that lead on from one state, on the same core
  std::function<void(const Machine& machine)> look;  ///< after each micro-step that is taken, on the core that takes it
};

/// A way from the start: from each state the so-manieth of all that can happen in it.
using Way = std::vector<std::uint32_t>;

struct RootSet {
  std::vector<Index> roots; ///< edges: those that are requested
  std::size_t found = 0, explored = 0;
  bool operator==(const RootSet&) const = default;
};

struct Searched {
  std::size_t states = 0, explored = 0, micro_steps = 0;
  Breadth breadth = Breadth::all;       ///< in which its ways can be followed
  bool complete = false;                ///< with this breadth
  std::vector<std::optional<Way>> seen; ///< assertion: the shortest way to what Watch looks for
  Happened happened;
  std::vector<bool> doubted; ///< assertion: of some state nobody can tell; empty: of none
  /// Micro-steps without an input that come back to where they began, where every body does what is usual: the way to
  /// that state, and how many they are. At most a few.
  struct Cycle {
    Way way;
    std::size_t length = 0;
    bool operator==(const Cycle&) const = default;
  };
  std::vector<Cycle> cycles;
  std::vector<RootSet> root_sets;
  std::size_t most_bytes = 0; ///< that states took at one time

  explicit Searched(const Tables& tables) : happened(tables) {}
};

Searched search(const Ground& ground, const SearchOptions& options);

/// One micro-step of a way, played again.
struct Taken {
  Happens happens;
  std::vector<Deed> deeds;
  Phase before = Phase::rest, after = Phase::rest;
};
std::vector<Taken> follow(const Ground& ground, const Way& way, Breadth breadth);
/// Whether the last micro-step of a way shows what Watch looks for, seen without any state that was put away between.
bool shows(const Ground& ground, const Way& way, Breadth breadth, std::size_t assertion);

} // namespace director::compiler
