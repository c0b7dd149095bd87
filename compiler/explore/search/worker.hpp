#pragma once
// SPDX-License-Identifier: MIT
// Expands a state: everything that can happen there, with all possible answers of bodies. Each core has its own worker;
// shared data is only read.

#include "compiler/explore/machine/machine.hpp"
#include "compiler/explore/search/frontier.hpp"
#include "compiler/explore/search/known.hpp"
#include "compiler/explore/search/search.hpp"
#include "compiler/explore/search/watch.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace director::compiler {

/// A successor state.
struct Step {
  std::uint64_t key = 0;
  std::uint32_t place = 0;
  bool usual = false; ///< no input, and every body gives its usual answer
  std::uint64_t roots = 0, watch = 0;
  std::size_t begin = 0, end = 0; ///< of Expansion::packed: the state; empty if it was known
};

/// An assertion that was decided by this step.
struct Seen {
  std::size_t assertion = 0;
  std::uint32_t place = 0;
};

/// The successors of one state.
struct Expansion {
  std::vector<Step> steps;
  Packed packed;
  std::vector<Seen> seen;
  std::size_t micro_steps = 0;
};

/// The requested roots; the first 64.
std::uint64_t requested_roots(const Machine& machine);

class Worker {
public:
  Worker(const Ground& ground, const SearchOptions& options)
      : machine(ground, options.breadth),
        watch(ground, options.assertions),
        foresees_(options.foresees),
        leave_(options.leave),
        look_(options.look) {}

  void begin_slice() { mine_.clear(); }

  /// `known`: the states, `played`: the micro-steps of earlier slices.
  void expand(const Waiting& from, const Known& known, const PlayedTable& played, Expansion& out);

  Machine machine;
  Watch watch;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> newly_played;

private:
  /// Takes it with all possible picks. Returns their number.
  std::uint32_t take_all(const Happens& happens, const Known& known, Expansion& out);
  void foresee(const PlayedTable& played);

  bool foresees_;
  std::function<void(const Machine&machine)> leave_, look_;
  std::vector<Happens> happens_;
  std::vector<std::uint64_t> foreseen_; ///< keys of micro-steps, in order: of an input, or of a body's answer
  std::vector<std::size_t> seen_;
  ChoiceSequence choices_;
  KeyTable mine_;                     ///< found in this slice
  PlayedTable mine_played_{1U << 15}; ///< and played, in any
  std::uint64_t watched_ = 0;         ///< what is remembered beside the expanded state
  std::uint32_t place_ = 0;           ///< of what is next
  bool moved_ = false;                ///< the machine is no longer in the state that was loaded
};

} // namespace director::compiler
