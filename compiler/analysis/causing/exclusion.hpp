#pragma once
// SPDX-License-Identifier: MIT
// Explains why a provider never begins although each of its conditions, and of those of its needs, holds at some time:
// they exclude each other, or the conditions of the groups above it.

#include "compiler/analysis/facts/facts.hpp"
#include "dsl/source/diagnostic.hpp"

#include <vector>

namespace director::analysis {

/// The conditions that exclude each other, each at its place, with the requests and needs that combine them. Empty if
/// the provider lacks something else. `reported`: an entry whose requester the finding names already.
std::vector<dsl::Note> explain_exclusion(const Model& model, const Facts& facts, ProviderId provider,
                                         const Task* reported = nullptr);

} // namespace director::analysis
