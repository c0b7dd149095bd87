#pragma once
// SPDX-License-Identifier: MIT
// Finds the conditions that nothing can satisfy, by declarations alone.

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/states/sources.hpp"

#include <vector>

namespace director::analysis {

/// What all sources of each state name.
IdTable<StateId, ValueSet> find_declared(const Model& model, const IdTable<StateId, std::vector<Source>>& sources);

/// In order of provider.
std::vector<Impossible> find_impossible(const Model& model, const IdTable<StateId, std::vector<Source>>& sources,
                                        const IdTable<StateId, ValueSet>& declared);

} // namespace director::analysis
