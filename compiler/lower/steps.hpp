#pragma once
// SPDX-License-Identifier: MIT
// The steps of lowering, each of which fills some of the tables. They run in this order: conditions get their rows
// before anything refers to them.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"

#include <optional>
#include <span>

namespace director::compiler {

/// Copies the rows behind the others of Tables::lists.
Range add_list(Lowered& out, std::span<const Index> rows);

template <class Tag>
Index row(Id<Tag> id) {
  return static_cast<Index>(id.value);
}

/// The row of a condition; empty if the engine never reads it.
std::optional<Index> condition_row(const Lowered& out, ConditionId id);

void lower_states(const Model& model, Lowered& out);
void lower_conditions(const Model& model, Lowered& out);
void lower_edges(const Model& model, Lowered& out);
void lower_providers(const Model& model, Lowered& out);
void lower_promises(const Model& model, Lowered& out);
void lower_groups(const Model& model, Lowered& out);
void lower_aims(const Model& model, Lowered& out);
void lower_components(const Model& model, Lowered& out);
void lower_users(Lowered& out);
void lower_traits(Lowered& out);

} // namespace director::compiler
