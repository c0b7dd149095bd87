#pragma once
// SPDX-License-Identifier: MIT
// Finds the sources of the values of a state.

#include "compiler/model/model.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

using namespace director::compiler;

/// A place in the text that gives a state values.
struct Source {
  enum class Kind { initial, external, expires, causing, sets, start, stop };
  Kind kind = Kind::initial;
  StateId state{};
  ValueSet values;
  Span span{};
  std::optional<ProviderId> provider; ///< of causing and sets
  std::optional<GroupId> group;       ///< of start and stop
};

/// By state, in the order of Kind, then of providers and groups.
IdTable<StateId, std::vector<Source>> find_sources(const Model& model);

/// Whether one of these providers sets it, or it comes from elsewhere; for a handler whether its group has one of them.
bool acts(const Model& model, const Source& source, const IdSet<ProviderId>& providers);

/// The provider's promise that satisfies the condition.
const ConditionUse& promise_of(const Model& model, ProviderId causer, ConditionId condition);

/// Every value that a provider may set, with a promise or without.
ValueSet values_set_by(const Model& model, const compiler::Provider& provider, StateId state);

} // namespace director::analysis
