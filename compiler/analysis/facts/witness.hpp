#pragma once
// SPDX-License-Identifier: MIT
// Explains why something may happen: for each fact the first rule that supports it, beginning with facts that need no
// support. Like facts.hpp, an over-approximation.

#include "compiler/analysis/facts/facts.hpp"
#include "dsl/source/diagnostic.hpp"

#include <optional>
#include <variant>

namespace director::analysis {

/// A state that has a value.
struct StateValue {
  StateId state{};
  std::int64_t value = 0;
};

/// A group that runs, a provider that runs, or a state's value.
using Goal = std::variant<GroupId, ProviderId, StateValue>;

/// The events one after another, the goal last; empty if it can never happen.
std::optional<std::vector<dsl::Note>> find_witness(const Model& model, const Facts& facts, const Goal& goal);

} // namespace director::analysis
