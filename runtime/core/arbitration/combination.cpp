// docs/semantics.md, section 4.4, Grant: the first combination of choices of several members, or of one that equals
// stand in the way of. SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/choices.hpp"
#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/base/parts.hpp"

const char director::part::search = 0;

namespace director::arbitration {

namespace {

/// What can claim the same group stands together, so that its choices are combined with each other and no others. The
/// first combination is the same: that of one cluster does not depend on another.
void sort_by_cluster(Context& x, Index count) {
  for (Index i = 1; i < count; ++i) {
    const Index edge = x.s.member[i].edge, cluster = x.t.cluster(edge);
    Index at = i;
    for (; at > 0 && x.t.cluster(x.s.member[at - 1].edge) > cluster; --at)
      x.s.member[at].edge = x.s.member[at - 1].edge;
    x.s.member[at].edge = edge;
  }
}

/// Of the members in order, up to the first one that has none. `record`: all choices of each, for whose sake they are
/// denied.
bool each_has_choice(Context& x, Index from, Index count, bool with_conditions, bool record) {
  for (Index at = from; at < count; ++at) {
    // Alone on the stack: entries_begin(x) of a later member is where the earlier one ends.
    if (at > 0) x.s.member[at - 1].entries_end = 0;
    bool any = false;
    for (bool fresh = true; next_choice(x, at, fresh, with_conditions, record); fresh = false) {
      any = true;
      if (record) continue;
      drop_entries(x, 0, x.s.member[at].entries_end);
      x.s.trial[target(x, x.s.member[at].edge)] = nil;
      break;
    }
    if (!any) return false;
  }
  return true;
}

} // namespace

/// Lexicographically over the members. For whose sake a choice was denied counts over all choices of each member, also
/// those that are never needed: so, where one can be denied, each member's are looked at once, and then combined.
bool search_combination(Context& x, Index count, bool with_conditions) {
  for (Index i = 0; count > 1 && i < count; ++i) x.s.member[i].edge = x.s.unit[i];
  const bool deniable =
      any(members(x, count), [&](const TriedMember& member) { return x.t.groups[target(x, member.edge)].deniable; });
  if (deniable && !each_has_choice(x, 0, count, with_conditions, true)) return false;
  Index at = 0;
  bool fresh = true, known = deniable; // that each has a choice for itself
  bool sorted = false;                 // by cluster
  for (;;) {
    if (next_choice(x, at, fresh, with_conditions, false)) {
      if (at + 1 == count) return true;
      ++at;
      fresh = true;
    } else if (at == 0) {
      return false;
    } else if (sorted) {
      if (x.t.cluster(x.s.member[at - 1].edge) !=
          x.t.cluster(x.s.member[at].edge)) { // no choice of another cluster helps
        leave_combination(x, at);
        return false;
      }
      --at;
      fresh = false;
    } else { // before all choices of those before it are tried with one that has none: a sum and no product
      leave_combination(x, at);
      if (!known && !each_has_choice(x, at, count, with_conditions, false)) return false; // those before it have one
      sort_by_cluster(x, count);
      sorted = true;
      at = 0;
      fresh = true;
    }
  }
}

} // namespace director::arbitration
