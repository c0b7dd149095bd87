// docs/semantics.md, section 4.2: which groups are available to an edge: equals never take from each other.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/availability.hpp"

#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/arbitration/pass.hpp"
#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/arbitration/trail.hpp"
#include "runtime/core/base/parts.hpp"

const char director::part::equals = 0;

namespace director::arbitration {

namespace {

/// Requested or needed by its requester's active provider, whose own chain is alive up to root.
bool alive(const Context& x, Index edge) {
  for (;;) {
    if (is_limbo(x, edge)) return false;
    const Index group = target(x, edge);
    const bool needed = x.s.last[group].holder == edge && x.s.last[group].needed();
    if (!requested(x, edge) && !needed) return false;
    const Index from = requester(x, edge);
    if (from == nil) return true;
    edge = x.s.last[from].holder;
    if (edge == nil) return false;
  }
}

/// All that the sweep over the whole component decided is undone; only which denials are forgotten stays.
void take_back(Context& x) {
  for (const Index g : opened(x)) {
    x.s.group_marks[g] &= mark::forgotten | mark::listed;
    clear(x, g);
  }
  for (const Index e : x.t.list(x.row.edges)) x.s.edge_marks[e] = 0;
  if (x.pushed_count != 0) mark_pushers(x);
}

} // namespace

/// The last holder of the group, another edge, is an equal of this one and would go on: equals never take from each
/// other.
bool kept_by_equal(Context& x, Index group, Index edge, bool record) {
  const Index holder = x.s.last[group].holder;
  if (injected(Fault::equals_take) || x.s.edge_marks[holder].has(mark::refused) || !alive(x, holder) ||
      compare(x, {edge, Chains::current}, {holder, Chains::previous}, false) != 0)
    return false;
  x.depends_on_last = x.depends_on_stale = x.depends_on_all_stale = true;
  if (x.s.group_marks[group].has(mark::forgotten)) return false;
  if (record && !x.s.group_marks[group].has(mark::denied)) {
    open(x, group);
    x.s.group_marks[group] |= mark::denied;
    x.s.denied[x.denied_count++] = group;
  }
  return true;
}

/// 4.2: the first holder for whose sake a group was denied that does not claim it in the end is forgotten. Which one is
/// the first is known only where all units were decided: those that stood may have been denied something too, for which
/// they have another choice. True: the sweep has to be repeated.
bool denied_in_vain(Context& x) {
  for (const Index group : std::span<const Index>{x.s.denied, x.denied_count}) {
    if (x.s.now[group].holder == x.s.last[group].holder || injected(Fault::denials_are_final)) continue;
    if (x.whole || injected(Fault::denials_of_who_stands_are_overlooked)) {
      x.s.group_marks[group] |= mark::forgotten;
      x.s.group_trail[group] |= trail::disturbed; // its last holder counts again in the next pass
      take_back(x);
    } else {
      x.s.news_count[x.component] = nil;
      begin(x);
    }
    return true;
  }
  return false;
}

} // namespace director::arbitration
