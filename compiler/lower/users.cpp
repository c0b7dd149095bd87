// Header: compiler/lower/steps.hpp. Test: tests/compiler/lower/lower_test.cpp.
// SPDX-License-Identifier: MIT
//
// Finds which decisions depend on what: for each group, those whose plans may contain it, and for each condition, the
// groups in whose `when` or `stay` it is. The engine decides again only what a change can reach along these.

#include "compiler/lower/steps.hpp"

#include <set>

namespace director::compiler {

namespace {

/// For each group, those that need it, with one of their providers.
std::vector<std::set<Index>> needers(const Lowered& out) {
  std::vector<std::set<Index>> found(out.groups.size());
  for (const director::Provider& provider : out.providers) {
    for (Index i = provider.needs.begin; i != provider.needs.end; ++i)
      found[out.edges[out.lists[i]].target].insert(provider.group);
  }
  return found;
}

std::set<Index> all_above(Index group, const std::vector<std::set<Index>>& needers) {
  std::set<Index> found{group};
  std::vector<Index> open{group};
  while (!open.empty()) {
    const Index at = open.back();
    open.pop_back();
    for (const Index above : needers[at]) {
      if (found.insert(above).second) open.push_back(above);
    }
  }
  return found;
}

std::vector<Index> listed(const std::set<Index>& rows) { return {rows.begin(), rows.end()}; }

} // namespace

void lower_users(Lowered& out) {
  const std::vector<std::set<Index>> direct = needers(out);
  for (Index g = 0; g < out.groups.size(); ++g) out.groups[g].users = add_list(out, listed(all_above(g, direct)));
  std::vector<std::set<Index>> waiting(out.conditions.size());
  for (const director::Provider& provider : out.providers) {
    for (const Range range : {provider.when, provider.stay}) {
      for (Index i = range.begin; i != range.end; ++i) waiting[out.lists[i]].insert(provider.group);
    }
  }
  for (Index c = 0; c < out.conditions.size(); ++c) out.conditions[c].groups = add_list(out, listed(waiting[c]));
}

} // namespace director::compiler
