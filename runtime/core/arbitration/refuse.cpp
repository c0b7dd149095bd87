// docs/semantics.md, section 4.4, Refuse: a unit is queued, for a reason.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/choices.hpp"
#include "runtime/core/arbitration/grant.hpp"
#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/arbitration/staleness.hpp"
#include "runtime/core/arbitration/trail.hpp"
#include "runtime/core/base/parts.hpp"

const char director::part::conditions = 0;

namespace director::arbitration {

namespace {

/// The false conditions of the combination in hand, member by member: its provider's, then its plan's.
Index collect_unmet(Context& x, Index count) {
  Index found = 0;
  for (Index place = 0; place < count; ++place) { // in order of the unit, also where the search had another one
    Index at = place;
    for (Index other = 0; count > 1 && x.s.member[at].edge != x.s.unit[place]; ++other) at = other;
    const auto add = [&](Index provider, Index edge) {
      if (stays(x, provider)) return;
      for (const Index condition : x.t.list(x.t.providers[provider].when)) {
        if (holds(x, condition) || waived(x, provider, condition, edge)) continue;
        x.s.unmet[found].member = x.s.member[at].edge;
        x.s.unmet[found++].condition = condition;
      }
    };
    add(x.s.member[at].provider, x.s.member[at].edge);
    for (Index i = entries_begin(x, at); i < x.s.member[at].entries_end; ++i)
      add(x.s.entry[i].provider, x.s.entry[i].need);
  }
  return found;
}

bool somebody_satisfies(const Context& x, Index condition) {
  for (const Index provider : x.t.list(x.t.conditions[condition].causers)) {
    if (x.s.enabled[provider] != 0) return true;
  }
  return false;
}

} // namespace

/// No combination is available with its conditions true.
void refuse(Context& x, Index count) {
  for (Index at = 0; at < count; ++at) x.s.edge_marks[x.s.member[at].edge] |= mark::refused;
  if (!combine(x, count, false)) return block(x, count);
  x.depends_on_last = true;
  const Index unmet = collect_unmet(x, count);
  const bool early = stale_requester(x, x.s.member[0].edge) || premature(x, count);
  x.depends_on_stale = x.depends_on_stale || early;
  leave_combination(x, count);
  explain(x, count, Why::waiting, x.s.unmet[0].condition);
  if (early) return keep_pushes(x, count);
  for (Index i = 0; i < unmet; ++i) {
    if (somebody_satisfies(x, x.s.unmet[i].condition) || injected(Fault::pushes_though_the_outside_decides)) continue;
    return; // it waits for the outside, and holds nobody back
  }
  push_for(x, count, unmet);
}

} // namespace director::arbitration
