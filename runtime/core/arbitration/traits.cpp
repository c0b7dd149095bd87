// docs/semantics.md, section 4: what follows from the tables and is asked so often that it is worth a byte.
// SPDX-License-Identifier: MIT
//
// How simple a group is, and where two edges can be equal (4.1, rule 5): only where a requester has two that go by one
// priority. Most people give each task a priority of its own; there nobody's last holder has to be looked at.

#include "runtime/core/arbitration/pass.hpp"

namespace director::arbitration {

namespace {

/// Of a group.
std::uint8_t traits_of(const Tables& t, const Group& group) {
  const auto is_simple = [&](const Group& row) {
    return row.providers.size() == 1 && t.providers[row.providers.begin].needs.empty();
  };
  std::uint8_t out = is_simple(group) ? trait::flat | trait::simple : trait::flat;
  for (Index p = group.providers.begin; p != group.providers.end; ++p) {
    if (!t.providers[p].when.empty() || !t.providers[p].stay.empty()) out |= trait::conditional;
    for (const Index need : t.list(t.providers[p].needs)) {
      if (!is_simple(t.groups[t.edges[need].target])) out &= static_cast<std::uint8_t>(~trait::flat);
    }
  }
  return out;
}

/// Edges of one requester with one priority part the chains of all that is below them. Where nothing is below either,
/// they lead to two groups, and never compete for one.
bool can_be_equal(Context& x, const Component& component) {
  Index* const first = x.s.candidate; // by urgency
  bool equals = false;
  const auto each = [&](Index e, auto&& take) {
    take(e, x.t.edges[e].need_urgency);
    const Range levels = x.t.edges[e].levels;
    for (Index at = levels.begin; at != levels.end; ++at) take(e, x.t.levels[at].urgency);
  };
  const auto forget = [&](Index, Index urgency) {
    if (urgency < x.t.edges.size()) first[urgency] = nil;
  };
  const auto leads_on = [&](Index e) { return !x.t.groups[x.t.edges[e].target].edges.empty(); };
  const auto look = [&](Index e, Index urgency) {
    if (urgency >= x.t.edges.size()) {
      equals = true; // there is no room to tell
    } else if (first[urgency] == nil) {
      first[urgency] = e;
    } else {
      equals = equals || (first[urgency] != e && (leads_on(first[urgency]) || leads_on(e)));
    }
  };
  Index roots = component.edges.begin;
  while (roots != component.edges.end && x.t.edges[x.t.lists[roots]].requester == nil) ++roots;
  for (Index i = component.edges.begin; i != roots; ++i) each(x.t.lists[i], forget);
  for (Index i = component.edges.begin; i != roots; ++i) each(x.t.lists[i], look);
  for (const Index g : x.t.list(component.groups)) {
    const Range edges = x.t.groups[g].edges;
    for (Index e = edges.begin; e != edges.end; ++e) each(e, forget);
    for (Index e = edges.begin; e != edges.end; ++e) each(e, look);
  }
  return equals;
}

} // namespace

void find_traits(Context& x) {
  for (Index g = 0; g < x.t.groups.size(); ++g) x.s.traits[g] = traits_of(x.t, x.t.groups[g]);
  for (Index c = 0; c < x.t.components.size(); ++c) {
    const Component& row = x.t.components[c];
    std::uint8_t out = can_be_equal(x, row) ? trait::equals | trait::compared : 0;
    for (const Index e : x.t.list(row.edges)) {
      const Range levels = x.t.edges[e].levels;
      for (Index level = levels.begin; level != levels.end; ++level) {
        if (x.t.levels[level].optional) out |= trait::compared;
      }
    }
    for (const Index g : x.t.list(row.groups)) {
      if (!x.t.groups[g].slots.empty()) out |= trait::alternatives;
    }
    x.s.component_traits[c] = out;
  }
}

} // namespace director::arbitration
