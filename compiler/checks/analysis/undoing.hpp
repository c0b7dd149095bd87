#pragma once
// Values that make a condition of a running task false again.

#include "compiler/model/model.hpp"

namespace director::checks {

using namespace director::compiler;

/// Of `values` those under which the provider, chosen while its condition held, cannot go on: neither by its `when` nor
/// by its `stay`, and no other provider of its group accepts them.
ValueSet undoing_values(const Model& model, ProviderId provider, ConditionId condition, const ValueSet& values);

} // namespace director::checks
