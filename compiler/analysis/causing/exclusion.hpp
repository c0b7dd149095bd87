#pragma once
// SPDX-License-Identifier: MIT
// Why a provider never begins although each of its conditions, and of those of its needs, holds at some time: they
// exclude each other, or what those above it run under.

#include "compiler/analysis/facts/facts.hpp"
#include "dsl/diagnostic.hpp"

#include <vector>

namespace director::analysis {

/// The conditions that exclude each other, each at its place, with the requests and needs that bring them together.
/// Nothing where the provider lacks something else. `reported`: an entry of which it is told already who requests it.
std::vector<dsl::Note> explain_exclusion(const Model& model, const Facts& facts, ProviderId provider,
                                         const Task* reported = nullptr);

} // namespace director::analysis
