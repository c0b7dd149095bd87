#pragma once
// SPDX-License-Identifier: MIT
// What several checks tell in notes, each at the place where it is written.

#include "compiler/analysis/chains/step.hpp"
#include "dsl/diagnostic.hpp"

#include <vector>

namespace director::analysis {

/// A chain: one note for each step, of a long one for the first and last few. `begins`: whether it goes on from the
/// note before.
void add_chain(const Model& model, const std::vector<ChainStep>& chain, std::vector<dsl::Note>& notes,
               dsl::Note::Link begins = dsl::Note::Link::first);

/// The provider promises what satisfies the condition.
dsl::Note causes(const Model& model, ProviderId causer, ConditionId condition);

/// The condition is one of the provider's `when`.
dsl::Note runs_only_while(const Model& model, ProviderId provider, const ConditionUse& condition);

} // namespace director::analysis
