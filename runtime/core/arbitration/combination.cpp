// docs/semantics.md, section 4.4, Grant: the first combination of choices of several members, or of one with equals.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/choices.hpp"

const char director::part::search = 0;

namespace director::arbitration {

namespace {

/// Sorts members that can claim the same group next to each other, so that only their choices are combined. The first
/// combination is the same: that of one cluster does not depend on another.
void sort_by_cluster(Context& x, Index count) {
  for (Index i = 1; i < count; ++i) {
    const Index edge = x.s.member[i].edge, cluster = x.t.cluster(edge);
    Index at = i;
    for (; at > 0 && x.t.cluster(x.s.member[at - 1].edge) > cluster; --at)
      x.s.member[at].edge = x.s.member[at - 1].edge;
    x.s.member[at].edge = edge;
  }
}

/// Whether each member by itself has a choice. `record`: tries all choices, to record denials.
bool each_has_choice(Context& x, Index from, Index count, bool with_conditions, bool record) {
  for (Index at = from; at < count; ++at) {
    // Its entries begin at 0: entries_begin(x) of a member is where the one before it ends.
    if (at > 0) x.s.member[at - 1].entries_end = 0;
    if (!next_choice(x, at, true, with_conditions, record)) return false;
    while (record && next_choice(x, at, false, with_conditions, true)) {}
    drop_entries(x, 0, x.s.member[at].entries_end);
    x.s.trial[target(x, x.s.member[at].edge)] = nil;
  }
  return true;
}

} // namespace

/// Searches in lexicographic order of the members. A denial counts for all choices of each member, also those that the
/// search never tries: so, if one can be denied, the choices of each member are gone through once before the search.
bool search_combination(Context& x, Index count, bool with_conditions) {
  for (Index i = 0; count > 1 && i < count; ++i) x.s.member[i].edge = x.s.unit[i];
  const bool deniable =
      any(members(x, count), [&](const TriedMember& member) { return x.t.groups[target(x, member.edge)].deniable; });
  if (deniable && !each_has_choice(x, 0, count, with_conditions, true)) return false;
  Index at = 0;
  bool fresh = true, sorted = false; // by cluster
  for (;;) {
    if (next_choice(x, at, fresh, with_conditions, false)) {
      if (at + 1 == count) return true;
      ++at;
      fresh = true;
    } else if (at == 0) {
      return false;
    } else if (sorted) {
      if (x.t.cluster(x.s.member[at - 1].edge) !=
          x.t.cluster(x.s.member[at].edge)) { // choices of another cluster make no difference
        leave_combination(x, at);
        return false;
      }
      --at;
      fresh = false;
    } else { // tested before its predecessors' choices are combined with it: the cost is a sum, not a product
      leave_combination(x, at);
      // Its predecessors have a choice; and all have, if they were gone through before.
      if (!deniable && !each_has_choice(x, at, count, with_conditions, false)) return false;
      sort_by_cluster(x, count);
      sorted = true;
      at = 0;
      fresh = true;
    }
  }
}

} // namespace director::arbitration
