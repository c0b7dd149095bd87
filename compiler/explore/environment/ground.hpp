#pragma once
// SPDX-License-Identifier: MIT
// The input of an exploration: the tables of a behaviour without time, and everything that the program and the bodies
// may do in it. Made once, then only read.
//
// The C++ bodies are unknown, so each may do all that it declares. Time is left out of the tables: a timer may be due
// whenever nothing else is left to do, in any order, so that a state expires by an input that sets it, and a wait, an
// `every` or a broken promise is a trigger that is fired. That is an over-approximation: what is true of it is true of
// the robot, and what is false of it is played again with real time before it is reported.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace director::compiler {

/// Classes of the values of a state that no condition distinguishes.
class ValueClasses {
public:
  ValueClasses() = default;
  ValueClasses(const State& state, const std::vector<const ValueSet*>& conditions);
  std::size_t count() const { return classes_.size(); }
  const ValueSet& values(std::size_t number) const { return classes_[number]; }
  /// count(): unset
  std::size_t of(std::int32_t value) const {
    if (value == unset) return classes_.size();
    const std::int64_t at = value - begins_.front();
    return at < static_cast<std::int64_t>(few_.size()) ? few_[static_cast<std::size_t>(at)] : piece_of(value);
  }

private:
  std::vector<ValueSet> classes_;
  std::vector<std::int64_t> begins_; ///< of pieces of the domain, ascending
  std::vector<std::size_t> pieces_;  ///< the class of each
  std::vector<std::size_t> few_;     ///< the class of each value, where they are few
  std::size_t piece_of(std::int32_t value) const;
};

struct RequestedLevel {
  Index edge = 0, level = 0;
};
using RequestedPack = std::vector<RequestedLevel>;

struct Put {
  Index state = 0;
  std::int32_t value = unset;
};
using Puts = std::vector<Put>;

/// The possible answers of a body. The first of each list is the usual one: the first pack or all tasks, and every
/// promise kept.
struct FreeBody {
  std::vector<RequestedPack> packs;
  std::size_t usual = 0; ///< so many of them, from the first one on, leave out no optional entry of a pack
  std::vector<Puts> puts;
};

struct Broken {
  Index provider = 0, trigger = 0;
};

/// Limits, beyond which less than everything is tried, and `narrowed` reports it.
inline constexpr std::size_t most_subsets_of = 8;     ///< flat tasks of which every subset is requested
inline constexpr std::size_t most_combinations = 256; ///< of values, levels or packs at one place

struct Ground {
  explicit Ground(const Model& model);
  Ground(const Model& model, Lowered lowered); ///< the result of lower() for the model
  Ground(const Ground&) = delete;
  Ground& operator=(const Ground&) = delete;

  /// From now on it is usual that bodies leave out optional entries of packs. False: it is already.
  bool make_all_packs_usual();

  const Model& model;
  const Lowered timed;                     ///< as the robot runs it, with time: what is found is played on it
  Lowered lowered;                         ///< without time; a group with a wait or `every` has a trigger
  Tables tables;                           ///< of `lowered`
  std::vector<ValueClasses> classes;       ///< state
  std::vector<FreeBody> bodies;            ///< provider
  std::vector<std::vector<Puts>> starting; ///< group: what its start handler may set
  std::vector<std::vector<Puts>> stopping;
  std::vector<Index> wake;             ///< group: that trigger; nil: it has none
  std::vector<RequestedPack> requests; ///< what the program may request in one input
  std::vector<Puts> sets;              ///< what one input may set
  std::vector<Index> triggers;         ///< that an input may fire and some provider listens to
  Puts expiries;                       ///< what a state expires to, unless an input can set that
  std::vector<Broken> broken;          ///< promises that some provider listens to
  std::vector<std::string> left_out;   ///< sentences without a full stop: what may happen and is not tried
  std::vector<std::string> narrowed;   ///< those of them because of which nothing is proven by a search
};

} // namespace director::compiler
