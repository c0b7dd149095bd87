#pragma once
// Chains as notes: one for each step, at the place where it is written.

#include "compiler/checks/analysis/claims.hpp"
#include "compiler/checks/analysis/needs.hpp"
#include "dsl/diagnostic.hpp"

#include <vector>

namespace director::checks {

void add_chain(const Model& model, const std::vector<ClaimStep>& chain, dsl::Diagnostic& finding);
void add_chain(const Model& model, const std::vector<NeedStep>& chain, dsl::Diagnostic& finding);

} // namespace director::checks
