#pragma once
// SPDX-License-Identifier: MIT
// Numbers that distinguish states of the engine. Equality of states: see state_hash.cpp.

#include "compiler/explore/environment/happens.hpp"
#include "compiler/explore/machine/hash.hpp"
#include "runtime/core/engine/engine.hpp"

#include <cstdint>
#include <vector>

namespace director::compiler {

/// A state as numbers: its values, and all the rest.
struct StateHash {
  std::uint64_t rest = 0, values = 0;
};

/// One number of the state, and of what is remembered beside it. Never 0. The same for states that behave alike, and
/// with a chance of 2^-64 for two others.
std::uint64_t key_of(const StateHash& hash, std::uint64_t watch);

class StateHasher {
public:
  /// Of the current state of `engine` at each call.
  StateHasher(const Ground& ground, const Engine& engine);

  StateHash hash(Phase phase) const;
  std::uint64_t values() const;

  // For callers that know what the next micro-step writes before anything is decided (foresight.hpp): the rest without
  // what a run of that group overwrites: its requests, done flag and reasons, and its place in the queue. Nil: an
  // input. Whether the last arbitration changed anything is left out too.
  std::uint64_t rest_before(Index group) const;
  /// The order in which a group's requests were made, if it counts. `request`: edge
  void add_places(Projection& out, Index group, const Requested* request) const;
  std::uint64_t mark_of(Index state, std::int32_t value) const {
    return marks_[first_mark_[state] + ground_.classes[state].of(value)];
  }

private:
  struct Contested {
    Range edges; ///< of one requester, of which some can be requested with the same priority
    Index group; ///< it; nil: root
  };
  void find_marks();
  void find_contested();
  void add_places(Projection& out, const Range& edges, const Requested* request) const;
  std::uint64_t* add_levels(Projection& out) const;
  std::uint64_t* add_holdings(Projection& out) const;
  void add_queue(Projection& out, Index first) const;

  const Ground& ground_;
  const Engine& engine_;
  std::vector<Index> observed_;         ///< states whose values count
  std::vector<std::size_t> first_mark_; ///< state: of its classes, in marks_
  std::vector<std::uint64_t> marks_;    ///< class of a state: its number in a StateHash; 0 for those that do not count
  std::vector<Contested> contested_;
  mutable std::vector<std::uint64_t> projection_;
  mutable std::vector<Index> requested_;
};

} // namespace director::compiler
