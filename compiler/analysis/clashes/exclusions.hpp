#pragma once
// SPDX-License-Identifier: MIT
// Explains why what one provider does excludes a condition or another provider: the place that shows it. Empty: it does
// not.

#include "compiler/analysis/input.hpp"
#include "dsl/source/diagnostic.hpp"

#include <optional>

namespace director::analysis {

/// A condition of `provider` that excludes what `other` causes.
std::optional<dsl::Note> excludes(const Model& model, ProviderId provider, ProviderId other);

/// Why a causing provider can run only while a condition is false.
std::optional<dsl::Note> runs_without(const Model& model, ProviderId causer, const ConditionUse& other);

/// Why a causing provider makes a condition false by what it causes or sets.
std::optional<dsl::Note> sets_against(const Model& model, ProviderId causer, const ConditionUse& other);

/// Why a causing provider makes a condition false: it cannot run otherwise, or sets the state to another value.
std::optional<dsl::Note> undoes(const Model& model, ProviderId causer, const ConditionUse& other);

} // namespace director::analysis
