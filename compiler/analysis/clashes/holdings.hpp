#pragma once
// SPDX-License-Identifier: MIT
// What a provider holds for itself as long as it runs, and whom it leads to.

#include "compiler/analysis/input.hpp"
#include "dsl/diagnostic.hpp"

#include <vector>

namespace director::analysis {

struct Holding {
  GroupId group{};
  dsl::Note note;      ///< where it takes the group
  bool by_need = true; ///< else it always requests it as a mandatory task
};

/// By its needs and by what every pack of it requests, each with what that cannot do without.
std::vector<Holding> holdings_of(const Model& model, const Shared& shared, ProviderId provider);

/// Where the provider requests the group; null: it does not.
const Task* entry_for(const Model& model, ProviderId provider, GroupId group);

/// It requests the group, or something that may come down to it.
bool leads_to(const Model& model, const Shared& shared, ProviderId provider, GroupId group);

} // namespace director::analysis
