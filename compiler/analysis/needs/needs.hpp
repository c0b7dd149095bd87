#pragma once
// SPDX-License-Identifier: MIT
// Why a provider has no plan: its needs lead around in a circle, or two of them come down to one group.

#include "compiler/analysis/chains/step.hpp"
#include "compiler/analysis/facts/facts.hpp"

#include <vector>

namespace director::analysis {

/// Circles of needs from which no choice of providers leads out, the first step where the circle is first met. Every
/// provider without a plan that is not explained by another one has either one of these or a conflict.
std::vector<std::vector<ChainStep>> find_need_cycles(const Model& model, const Facts& facts, Budget& budget);

/// The providers whose needs exclude each other, or for which that was not decided.
std::vector<ProviderId> find_need_conflicts(const Model& model, const Facts& facts, Budget& budget);

/// A shortest way from one group to another by needs; empty if they are the same.
std::vector<ChainStep> need_path(const Model& model, GroupId from, GroupId to);

} // namespace director::analysis
