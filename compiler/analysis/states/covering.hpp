#pragma once
// SPDX-License-Identifier: MIT
// Whether some regions together cover a box of values of states, and what they leave open. To decide it is NP-complete:
// it is the question whether a formula in disjunctive normal form holds always.

#include "compiler/analysis/effort/budget.hpp"
#include "compiler/analysis/states/region.hpp"

#include <map>
#include <vector>

namespace director::analysis {

/// What a state may be.
struct Possible {
  ValueSet values;
  bool unset = false;
  bool empty() const { return values.empty() && !unset; }
  bool operator==(const Possible&) const = default;
};

/// States that are looked at, each for itself; any other state may be anything that it can be.
using Box = std::map<StateId, Possible>;

enum class Covering { covered, open, undecided };

/// Whether the regions cover all of `start`. A state that `start` says nothing about has one of `values` or, where it
/// may, none. `opening`: takes a part of `start` outside all of the regions, if there is one; it cannot be widened.
Covering find_covering(const Model& model, const IdTable<StateId, ValueSet>& values, const Box& start,
                       const std::vector<Region>& regions, Budget& budget, Box* opening = nullptr);

} // namespace director::analysis
