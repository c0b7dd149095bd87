// docs/semantics.md, section 4.2: which groups are available to an edge: equals never take from each other.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/pass.hpp"
#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/arbitration/trail.hpp"

const char director::part::equals = 0;

namespace director::arbitration {

namespace {

/// Whether the edge is requested, or needed in the last pass, and so is each edge of its chain up to root.
bool alive(const Context& x, Index edge) {
  while (!is_limbo(x, edge)) { // nor nil
    const GroupAssignment& last = x.s.last[target(x, edge)];
    if (!requested(x, edge) && !(last.holder == edge && last.needed())) return false;
    const Index from = requester(x, edge);
    if (from == nil) return true;
    edge = x.s.last[from].holder;
  }
  return false;
}

} // namespace

/// Whether an equal of this edge holds the group and may keep it: equals never take from each other.
bool kept_by_equal(Context& x, Index group, Index edge, bool record) {
  const Index holder = x.s.last[group].holder;
  if (x.s.edge_marks[holder].has(mark::refused) || !alive(x, holder) ||
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

/// Finds the first holder for which a group was denied and that does not claim it in the end; its denial is forgotten
/// (4.2). It is known only after a pass that decides all units: units that were not decided again may have been denied
/// something too, and have made another choice. True: the sweep has to be repeated.
bool denied_in_vain(Context& x) {
  for (const Index group : std::span<const Index>{x.s.denied, x.denied_count}) {
    if (x.s.now[group].holder == x.s.last[group].holder) continue;
    if (x.whole) {
      x.s.group_marks[group] |= mark::forgotten;
      open_all(x, mark::forgotten);
    } else {
      x.s.news_count[x.component] = nil;
      begin(x);
    }
    return true;
  }
  return false;
}

} // namespace director::arbitration
