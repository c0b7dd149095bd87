#pragma once
// SPDX-License-Identifier: MIT
// Which providers cause a condition (Model::causes), found for all conditions in one pass over the promises.

#include "compiler/model/model.hpp"

#include <vector>

namespace director::compiler {

/// For each condition the providers that cause it, in order.
using Causers = IdTable<ConditionId, std::vector<ProviderId>>;
Causers find_causers(const Model& model);

} // namespace director::compiler
