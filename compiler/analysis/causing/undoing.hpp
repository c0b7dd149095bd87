#pragma once
// SPDX-License-Identifier: MIT
// Values that make a condition of a running task false again.

#include "compiler/analysis/causing/wants.hpp"

namespace director::analysis {

/// Of `values` those under which the provider, chosen while its condition held, cannot go on: neither by its `when` nor
/// by its `stay`, and no other provider of its group accepts them.
ValueSet undoing_values(const Model& model, ProviderId provider, ConditionId condition, const ValueSet& values);

/// What helps where a wanted condition is undone by these values.
std::string stay_help(const Model& model, const Want& want, const ValueSet& values);

} // namespace director::analysis
