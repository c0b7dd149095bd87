// Door: runtime/core/arbitration/arbitration.hpp. Test: tests/runtime/core/arbitration/arbitration_test.cpp.
// SPDX-License-Identifier: MIT
//
// What follows from the tables and is asked so often that it is worth a byte: how simple a group is, and where two
// edges can be equal (4.1, rule 5): only where a requester has two that go by one priority. Most people give each task
// a priority of its own; there nobody's last holder has to be looked at.
#include "runtime/core/arbitration/arbitration.hpp"
#include "runtime/core/base/marks.hpp"

namespace director {

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
} // namespace

void Pass::find_traits() {
  for (Index g = 0; g < t_.groups.size(); ++g) s_.traits[g] = traits_of(t_, t_.groups[g]);
  for (Index c = 0; c < t_.components.size(); ++c) {
    const Component& row = t_.components[c];
    std::uint8_t out = can_be_equal(row) ? trait::equals | trait::compared : 0;
    for (const Index e : t_.list(row.edges)) {
      const Range levels = t_.edges[e].levels;
      for (Index level = levels.begin; level != levels.end; ++level) {
        if (t_.levels[level].optional) out |= trait::compared;
      }
    }
    for (const Index g : t_.list(row.groups)) {
      if (!t_.groups[g].slots.empty()) out |= trait::alternatives;
    }
    s_.component_traits[c] = out;
  }
}

/// Edges of one requester with one priority part the chains of all that is below them. Where nothing is below either,
/// they lead to two groups, and never compete for one.
bool Pass::can_be_equal(const Component& component) {
  Index* const first = s_.candidate; // by urgency
  bool equals = false;
  const auto each = [&](Index e, auto&& visit) {
    visit(e, t_.edges[e].need_urgency);
    const Range levels = t_.edges[e].levels;
    for (Index at = levels.begin; at != levels.end; ++at) visit(e, t_.levels[at].urgency);
  };
  const auto clear = [&](Index, Index urgency) {
    if (urgency < t_.edges.size()) first[urgency] = nil;
  };
  const auto leads_on = [&](Index e) { return !t_.groups[t_.edges[e].target].edges.empty(); };
  const auto look = [&](Index e, Index urgency) {
    if (urgency >= t_.edges.size()) {
      equals = true; // there is no room to tell
    } else if (first[urgency] == nil) {
      first[urgency] = e;
    } else {
      equals = equals || (first[urgency] != e && (leads_on(first[urgency]) || leads_on(e)));
    }
  };
  Index roots = component.edges.begin;
  while (roots != component.edges.end && t_.edges[t_.lists[roots]].requester == nil) ++roots;
  for (Index i = component.edges.begin; i != roots; ++i) each(t_.lists[i], clear);
  for (Index i = component.edges.begin; i != roots; ++i) each(t_.lists[i], look);
  for (const Index g : t_.list(component.groups)) {
    const Range edges = t_.groups[g].edges;
    for (Index e = edges.begin; e != edges.end; ++e) each(e, clear);
    for (Index e = edges.begin; e != edges.end; ++e) each(e, look);
  }
  return equals;
}

} // namespace director
