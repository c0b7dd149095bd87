#pragma once
// SPDX-License-Identifier: MIT
// Why something may happen: for each of the facts the first rule that supports it, from what needs no support on. Where
// facts.hpp says "may", so does this.

#include "compiler/analysis/facts/facts.hpp"
#include "dsl/diagnostic.hpp"

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

/// What happens one after another, the goal last; nothing if it can never be.
std::optional<std::vector<dsl::Note>> find_witness(const Model& model, const Facts& facts, const Goal& goal);

} // namespace director::analysis
