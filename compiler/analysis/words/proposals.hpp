#pragma once
// SPDX-License-Identifier: MIT
// The wording of what several checks propose.

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/facts/push_exclusion.hpp"
#include "compiler/model/model.hpp"
#include "dsl/source/diagnostic.hpp"

#include <functional>
#include <string>
#include <vector>

namespace director::analysis {

/// ", and put it last", if the provider would otherwise be preferred to others of its group and never leave them
/// anything, once the conditions for which `removed` is true are removed from it.
std::string put_last(const compiler::Model& model, compiler::ProviderId id,
                     const std::function<bool(const compiler::ConditionUse&)>& removed);

/// Adds what the two require of a state that keeps the one from ever pushing the other.
void add_exclusion(const compiler::Model& model, const PushExclusion& exclusion, compiler::StateId state,
                   compiler::ProviderId waiter, compiler::ProviderId causer, std::vector<dsl::Note>& notes);
/// Help for that: while the state has these values, nothing can be pushed for what is wanted.
std::string propose_causer(const compiler::Model& model, compiler::StateId state, const compiler::ValueSet& values,
                           compiler::ConditionId wanted);

/// Sets this help, with the advice to leave the provider out; but not if a group that needs its group may hold it by
/// this provider, whose body may never run: that is noted.
void propose_or_leave_out(const compiler::Model& model, const Facts& facts, compiler::ProviderId provider,
                          const std::string& help, dsl::Diagnostic& finding);

} // namespace director::analysis
