#pragma once
// SPDX-License-Identifier: MIT
// The wording of what several checks propose.

#include "compiler/model/model.hpp"

#include <functional>
#include <string>

namespace director::analysis {

/// ", and put it last", if the provider would otherwise be preferred to others of its group and never leave them
/// anything, once the conditions for which `removed` is true are removed from it.
std::string put_last(const compiler::Model& model, compiler::ProviderId id,
                     const std::function<bool(const compiler::ConditionUse&)>& removed);

} // namespace director::analysis
