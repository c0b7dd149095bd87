#pragma once
// SPDX-License-Identifier: MIT
// Explains why a provider has no plan: its needs form a cycle, or two of them lead to one group.

#include "compiler/analysis/chains/step.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/graph/graph.hpp"

#include <vector>

namespace director::analysis {

/// Cycles of needs that no choice of providers leaves, the first step where the cycle is entered first. Every provider
/// without a plan that is not explained by another one has either one of these or a conflict.
std::vector<std::vector<ChainStep>> find_need_cycles(const Model& model, const Graph& graph, const Facts& facts,
                                                     Budget& budget);

/// The providers whose needs exclude each other, or for which that was not decided.
std::vector<ProviderId> find_need_conflicts(const Model& model, const Facts& facts, Budget& budget);

/// A shortest path from one group to another by needs; empty if they are the same.
std::vector<ChainStep> need_path(const Model& model, GroupId from, GroupId to);
/// Whether one group is the other, or may need it at any depth.
inline bool needs_lead_to(const Model& model, GroupId from, GroupId to) {
  return from == to || !need_path(model, from, to).empty();
}

} // namespace director::analysis
