#pragma once
// SPDX-License-Identifier: MIT
// Why what one provider does leaves no room for a condition or for another provider: the place that shows it. Nothing:
// it leaves room.

#include "compiler/analysis/input.hpp"
#include "dsl/diagnostic.hpp"

#include <optional>

namespace director::analysis {

/// A condition of `provider` that what `other` causes excludes.
std::optional<dsl::Note> excludes(const Model& model, ProviderId provider, ProviderId other);

/// Why a causing provider can run only while a condition is false.
std::optional<dsl::Note> runs_without(const Model& model, ProviderId causer, const ConditionUse& other);

/// Why a causing provider makes a condition false: it cannot run otherwise, or sets the state to something else.
std::optional<dsl::Note> undoes(const Model& model, ProviderId causer, const ConditionUse& other);

} // namespace director::analysis
