#pragma once
// Finds what leads out of a state: everything that can happen there, with everything that bodies can do. Each core has
// a worker of its own; what all of them know is only read.

#include "compiler/explore/known.hpp"
#include "compiler/explore/machine.hpp"
#include "compiler/explore/search.hpp"
#include "compiler/explore/watch.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace director::compiler {

/// A state that something leads to.
struct Step {
  std::uint64_t key = 0;
  std::uint32_t place = 0;
  bool usual = false; ///< no input, and every body does what is usual
  std::uint64_t roots = 0;
  Packed state; ///< empty where it was known
};

/// What shows an assertion.
struct Seen {
  std::size_t assertion = 0;
  std::uint32_t place = 0;
};

/// What leads out of one state.
struct Expansion {
  std::vector<Step> steps;
  std::vector<Seen> seen;
  std::size_t micro_steps = 0;
};

/// The roots that are requested; the first 64.
std::uint64_t requested_roots(const Machine& machine);

class Worker {
public:
  Worker(const Ground& ground, const SearchOptions& options)
      : machine(ground, options.breadth),
        watch(ground, options.assertions) {}

  void begin_slice() { mine_.clear(); }

  /// `known`: the states, `played`: what was played in the slices before.
  void expand(const Packed& from, const Known& known, const Played& played, Expansion& out);

  Machine machine;
  Watch watch;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> newly_played;

private:
  /// Takes it with all that the tape can be from where it is.
  void take_all(const Happens& happens, const Known& known, Expansion& out);

  std::vector<Happens> happens_;
  std::vector<std::size_t> seen_;
  Tape tape_;
  Known mine_;                   ///< found in this slice
  Played mine_played_{1U << 15}; ///< and played, in any
  std::uint32_t place_ = 0;      ///< of what is next
  bool moved_ = false;           ///< the machine is elsewhere than where it was loaded
};

} // namespace director::compiler
