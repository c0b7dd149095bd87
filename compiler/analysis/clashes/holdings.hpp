#pragma once
// SPDX-License-Identifier: MIT
// Finds what a provider holds as long as it runs, and the groups that it leads to.

#include "compiler/analysis/input.hpp"
#include "dsl/source/diagnostic.hpp"

#include <vector>

namespace director::analysis {

struct Holding {
  GroupId group{};
  dsl::Note note;      ///< where it takes the group
  bool by_need = true; ///< else every pack requests it as a mandatory task
};

/// By its needs and by what each of its packs requests, each with what that cannot run without.
std::vector<Holding> holdings_of(const Model& model, const Shared& shared, ProviderId provider);

/// A group that one provider needs, and another one, above it, keeps by a need of its own.
struct KeptNeed {
  GroupId group{};
  dsl::Note needed, kept;
};
/// One for each of these providers; none if one of them needs no such group.
std::vector<KeptNeed> find_kept_needs(const Model& model, const Shared& shared, ProviderId above,
                                      const std::vector<ProviderId>& providers);

/// Whether it requests the group, or a task that may come to hold it (Claims).
bool leads_to(const Model& model, const Shared& shared, ProviderId provider, GroupId group);

} // namespace director::analysis
