#pragma once
// SPDX-License-Identifier: MIT
// Decides whether some regions together cover a box of values of states, and what they leave open. This is NP-complete:
// it is whether a formula in disjunctive normal form is a tautology.

#include "compiler/analysis/effort/budget.hpp"
#include "compiler/analysis/states/region.hpp"

#include <map>
#include <vector>

namespace director::analysis {

/// The possible values of a state.
struct Possible {
  ValueSet values;
  bool unset = false;
  bool empty() const { return values.empty() && !unset; }
  bool operator==(const Possible&) const = default;
};

/// The examined states, each independent; any other state may have any of its values.
using Box = std::map<StateId, Possible>;

/// The states of the region, each with those of `values` that it accepts, and never unset.
Box box_of(const IdTable<StateId, ValueSet>& values, const Region& region);

enum class Covering { covered, open, undecided };

/// Whether the regions cover all of `start`. A state that is not in `start` has one of `values` or, if it may be, is
/// unset. `opening`: gets a part of `start` outside all regions, if there is one; it cannot be widened.
Covering find_covering(const Model& model, const IdTable<StateId, ValueSet>& values, const Box& start,
                       const std::vector<Region>& regions, Budget& budget, Box* opening = nullptr);

} // namespace director::analysis
