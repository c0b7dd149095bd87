// Door: runtime/core/arbitration.hpp. Test: tests/runtime/core/arbitration_test.cpp.
//
// Where can two edges be equal (4.1, rule 5)? Only where a requester has two that go by one priority. Most people give
// each task a priority of its own; there nobody's last holder has to be looked at.
#include "runtime/core/arbitration.hpp"

namespace director {

/// Edges of one requester with one priority part the chains of all that is below them. Where nothing is below either,
/// they lead to two groups, and never compete for one.
void Pass::find_equals() {
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
  for (Index c = 0; c < t_.components.size(); ++c) {
    equals = false;
    const Component& row = t_.components[c];
    Index roots = row.edges.begin;
    while (roots != row.edges.end && t_.edges[t_.lists[roots]].requester == nil) ++roots;
    for (Index i = row.edges.begin; i != roots; ++i) each(t_.lists[i], clear);
    for (Index i = row.edges.begin; i != roots; ++i) each(t_.lists[i], look);
    for (const Index g : t_.list(row.groups)) {
      const Range edges = t_.groups[g].edges;
      for (Index e = edges.begin; e != edges.end; ++e) each(e, clear);
      for (Index e = edges.begin; e != edges.end; ++e) each(e, look);
    }
    s_.equals[c] = equals ? 1 : 0;
  }
}

} // namespace director
